/** A person at the keyboard: the real reducer and panels' state, with services that take notes. */
import type { nothing, TemplateResult } from "lit";
import type { Services } from "../../../web/src/contract";
import type { Action } from "../../../web/src/model/actions";
import { reduce } from "../../../web/src/model/reduce";
import type { State } from "../../../web/src/model/state";
import { press } from "../../../web/src/ui/keyboard";
import { follow } from "../../../web/src/ui/local";
import { INITIAL_LOCAL, type Local, type Page } from "../../../web/src/ui/page";
import { NO_AR } from "../no_ar";

const PLAIN = { shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };

export interface Desk {
  readonly state: State;
  readonly local: Local;
  readonly saved: number;
  readonly page: Page;
  act(...actions: readonly Action[]): void;
  /** Presses keys in order, with the same modifiers; whether the last one meant something. */
  type(keys: readonly string[], modifiers?: Partial<typeof PLAIN>): boolean;
}

export function sitDown(initial: State): Desk {
  let [state, local, saved]: [State, Local, number] = [initial, INITIAL_LOCAL, 0];
  const services: Services = {
    viewPoint: () => [1, 1],
    saveScene: () => {
      saved += 1;
    },
    openSceneFile: async () => {},
    openRoom: async () => {},
    exportRoom: async () => {},
    exportHeatMap: async () => {},
    fetchKnowledge: async () => null,
    fetchJoin: async () => null,
    quickLook: false,
    ar: NO_AR,
  };
  function dispatch(action: Action): void {
    const before = state;
    state = reduce(state, action);
    local = follow(local, before, state);
  }
  const page = (): Page => ({
    state,
    local,
    services,
    dispatch,
    change(changed) {
      local = { ...local, ...changed };
    },
  });
  return {
    get state() {
      return state;
    },
    get local() {
      return local;
    },
    get saved() {
      return saved;
    },
    get page() {
      return page();
    },
    act: (...actions) => actions.forEach(dispatch),
    type: (keys, modifiers = {}) =>
      keys.map((key) => press(page(), { ...PLAIN, ...modifiers, key })).at(-1) ?? false,
  };
}

/** The words of a template as they would be read, markup and handlers left out. */
export function wordsOf(template: TemplateResult | typeof nothing): string {
  return textOf(template)
    .replaceAll(/<[^>]*>/g, " ")
    .replaceAll(/\s+/g, " ")
    .trim();
}

function textOf(value: unknown): string {
  if (Array.isArray(value)) return value.map(textOf).join(" ");
  if (isTemplate(value)) {
    return value.strings.map((part, i) => part + textOf(value.values[i])).join("");
  }
  return typeof value === "string" || typeof value === "number" ? String(value) : "";
}

function isTemplate(value: unknown): value is TemplateResult {
  return typeof value === "object" && value !== null && "strings" in value;
}
