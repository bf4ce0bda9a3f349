/** The panels round the room: mounted once, rendered anew with every state. */
import "../styles/index.css";
import { html, render, type TemplateResult } from "lit";
import type { Services, View } from "../contract";
import type { State } from "../model/state";
import type { Dispatch } from "../store";
import { announcement } from "./announcements";
import { drawingPanel } from "./drawing";
import { header } from "./header";
import { help } from "./help";
import { createInsets } from "./insets";
import { press } from "./keyboard";
import { layersPanel } from "./layers";
import { follow } from "./local";
import { objectList } from "./objects";
import { INITIAL_LOCAL, type Local, type Page } from "./page";
import { placePanel } from "./place";
import { reasonsPanel } from "./reasons";
import { selectionPanel } from "./selection";
import { sheetHandle } from "./sheet";
import { nextStep, situation, toast } from "./situation";
import { cameras, tools } from "./tools";
import { welcome } from "./welcome";

/** What is said waits until nothing newer has come for this long, milliseconds. */
const CALM = 250;

/** Shows the panels in the element and listens to the keys of the window. */
export function mountUi(element: HTMLElement, dispatch: Dispatch, services: Services): View {
  let state: State | null = null;
  let local: Local = INITIAL_LOCAL;
  const insets = createInsets(element);
  const say = createVoice();
  const pageOf = (state: State): Page => ({ state, local, services, dispatch, change });
  function change(changed: Partial<Local>): void {
    local = { ...local, ...changed };
    if (state !== null) draw(state);
  }
  function draw(state: State): void {
    render(panels(pageOf(state)), element);
    syncHelp(element, state.help);
    insets.watch();
  }
  const onKey = (event: KeyboardEvent): void => {
    if (state === null || !isForTheRoom(event)) return;
    if (press(pageOf(state), event)) event.preventDefault();
  };
  window.addEventListener("keydown", onKey);
  return {
    show(next) {
      const before = state;
      state = next;
      if (before !== null) {
        local = follow(local, before, next);
        say(announcement(before, next));
      } else if (!next.welcome) {
        local = { ...local, guide: "done" };
      }
      draw(next);
    },
    dispose() {
      window.removeEventListener("keydown", onKey);
      insets.dispose();
      render(html``, element);
    },
  };
}

/** Everything, in the order in which Tab goes through it. */
export function panels(page: Page): TemplateResult {
  return html`
    ${header(page)} ${tools(page)}
    <div class="over">
      ${objectList(page)} ${toast(page)} ${cameras(page)}
      <div class="lower">${situation(page)} ${nextStep(page)} ${welcome(page)}</div>
    </div>
    <aside class="panel" aria-label="Panel" data-sheet=${page.local.sheet}>
      ${sheetHandle(page)}
      <div class="parts">
        ${parts(page)}
      </div>
    </aside>
    ${help(page)}
  `;
}

/** What the panel holds just now, the most wanted first. */
function parts(page: Page): unknown {
  const { state, local } = page;
  if (state.tool !== "select") return [drawingPanel(page), layersPanel(page)];
  if (state.placing !== null) return [placePanel(page), reasonsPanel(page), layersPanel(page)];
  const order = [selectionPanel(page), placePanel(page)];
  return [...(local.placed === null ? order : order.toReversed()), layersPanel(page)];
}

/** Keys typed into a field, pressed on a button or in a dialog belong there. */
function isForTheRoom(event: KeyboardEvent): boolean {
  const target = event.target as Element;
  if (target.closest("input:not([type=radio], [type=checkbox]), textarea, dialog, [popover]")) {
    return false;
  }
  const onControl = target.closest("button, a, summary, input") !== null;
  return !(
    onControl &&
    ["Enter", " ", "ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"].includes(event.key)
  );
}

function syncHelp(element: HTMLElement, open: boolean): void {
  const dialog = element.querySelector<HTMLDialogElement>("dialog.help");
  if (dialog === null || dialog.open === open) return;
  if (open) dialog.showModal();
  else dialog.close();
}

/** Says the newest sentence once things are calm, so that a drag does not read out each step. */
function createVoice(): (words: string | null) => void {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  return (words) => {
    const announcer = document.getElementById("announcer");
    if (announcer === null || words === null) return;
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      announcer.textContent = words;
    }, CALM);
  };
}
