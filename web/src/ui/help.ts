/** The help: all keys, from the table that makes them work, and all gestures. */
import { html, type TemplateResult } from "lit";
import { button, iconButton } from "./controls";
import { KEYS, type KeyGroup } from "./keyboard";
import { categoryAtHand, openKnowledge } from "./knowledge";
import type { Page } from "./page";

const GROUPS: readonly KeyGroup[] = ["Place", "Move", "Draw", "Look", "Always"];

const GESTURES: readonly { gesture: string; words: string }[] = [
  { gesture: "Drag the floor", words: "Look around" },
  { gesture: "Wheel, or pinch", words: "Come closer, go away" },
  { gesture: "Click or tap a thing", words: "Select it" },
  { gesture: "Drag a selected thing", words: "Move it; Alt lets go of walls" },
  { gesture: "Drag its ring", words: "Turn it" },
  { gesture: "Drag the see-through thing", words: "Try another place and read why" },
  { gesture: "Click or tap the bare floor", words: "While placing: why not there?" },
];

export function help(page: Page): TemplateResult {
  const { state, dispatch } = page;
  const showKnowledge = (): void => {
    dispatch({ type: "toggle-help" });
    openKnowledge(page, categoryAtHand(page));
  };
  return html`<dialog
    class="help"
    aria-labelledby="help-title"
    @close=${() => {
      if (state.help) dispatch({ type: "toggle-help" });
    }}
  >
    <div class="title">
      <h2 id="help-title">Keys and gestures</h2>
      ${iconButton({ icon: "close", label: "Close", run: () => dispatch({ type: "toggle-help" }) })}
    </div>
    <p>
      SceneGen shows where a piece of furniture would go in a room like yours, which way it should
      face, and why. Pick something; the bright floor is where people put it.
    </p>
    ${button({ icon: "info", label: "What does it know?", keys: "K", run: showKnowledge })}
    <div class="columns">
      ${GROUPS.map(
        (group) => html`<div>
          <h3>${group}</h3>
          <dl>
            ${KEYS.filter((key) => key.group === group).map(
              ({ label, words }) => html`<dt><kbd>${label}</kbd></dt><dd>${words}</dd>`,
            )}
          </dl>
        </div>`,
      )}
      <div>
        <h3>Mouse and fingers</h3>
        <dl class="gestures">
          ${GESTURES.map(({ gesture, words }) => html`<dt>${gesture}</dt><dd>${words}</dd>`)}
        </dl>
      </div>
    </div>
    <p>Tab goes through the things in the room; the arrows move the one that has the focus.</p>
  </dialog>`;
}
