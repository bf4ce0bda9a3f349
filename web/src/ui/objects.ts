/** The things in the room as a list for the keyboard and for screen readers. */
import { html, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { Selection } from "../model/state";
import type { SceneRecord } from "../net/protocol.gen";
import type { Page } from "./page";
import { boxInWords, openingInWords, sceneInWords } from "./whereabouts";

interface Thing {
  readonly selection: Selection & { readonly id: string };
  readonly words: string;
}

/** Each takes the focus in turn; the focused one is selected, so that the arrows move it. */
export function objectList({ state, dispatch }: Page): TemplateResult {
  const { scene, selection } = state;
  const isSelected = (thing: Thing): boolean =>
    selection !== null && "id" in selection && selection.id === thing.selection.id;
  return html`<ul class="objects" role="listbox" aria-label="Things in the room: ${sceneInWords(scene)}">
    ${repeat(
      thingsIn(scene),
      ({ selection }) => selection.id,
      (thing) => html`<li
        role="option"
        tabindex="0"
        aria-selected=${isSelected(thing)}
        @focus=${() => {
          if (!isSelected(thing)) dispatch({ type: "select", selection: thing.selection });
        }}
      >
        ${thing.words}
      </li>`,
    )}
  </ul>`;
}

function thingsIn({ boxes, room }: SceneRecord): readonly Thing[] {
  return [
    ...boxes.map((box) => thing("box", box.id, boxInWords(box, room))),
    ...room.doors.map((door) => thing("door", door.id, `Door, ${openingInWords(door, room)}`)),
    ...room.windows.map((one) => thing("window", one.id, `Window, ${openingInWords(one, room)}`)),
  ];
}

function thing(kind: "box" | "door" | "window", id: string, words: string): Thing {
  return { selection: { kind, id }, words };
}
