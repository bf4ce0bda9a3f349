/** The room seen through the camera: the way in, what to press there, the way out. */
import { html, nothing, type TemplateResult } from "lit";
import { likelyCategories } from "../model/labels";
import type { Ar } from "../model/state";
import { canCapture, foundInWords, markInWords, obstacleInWords } from "./ar_words";
import { chips } from "./categories";
import { button, iconButton, section, toolButton } from "./controls";
import { openJoin } from "./join";
import type { Page } from "./page";
import { allPlaced } from "./quick_look";
import { selectionPanel } from "./selection";
import { inSentence } from "./words";

/** The way in, beside the other ways to look at the room. */
export function arButton({ change }: Page): TemplateResult {
  return toolButton({
    icon: "phone",
    label: "Camera",
    keys: "V",
    run: () => change({ arDoor: true }),
  });
}

/** What the camera is for, before the browser asks for it. */
export function arDoor(page: Page): TemplateResult {
  const { state, change } = page;
  const obstacle = obstacleInWords(state.arSupport);
  return html`<dialog class="help ar-door" aria-labelledby="ar-door-title" @close=${() => change({ arDoor: false })}>
    <div class="title">
      <h2 id="ar-door-title">See it in your own room</h2>
      ${iconButton({ icon: "close", label: "Close", run: () => change({ arDoor: false }) })}
    </div>
    ${obstacle === null ? invitation(page) : instead(page, obstacle)}
  </dialog>`;
}

/** What there is where there is no camera view. */
function instead(page: Page, obstacle: string): TemplateResult {
  if (!page.services.quickLook) {
    const open = (): void => {
      page.change({ arDoor: false });
      openJoin(page);
    };
    return html`<p>${obstacle}</p>
      <div class="ways-in desk-only">
        ${button({ icon: "phone", label: "Open on your phone", run: open })}
      </div>`;
  }
  return html`<p>
      ${obstacle} What you place in it you can look at in the real room: place something, then press
      “See it in your room”.
    </p>
    <div class="ways-in">${allPlaced(page)}</div>`;
}

function invitation({ state, services, change }: Page): TemplateResult {
  const begin = (room: Ar["room"]) => (): void => {
    change({ arDoor: false });
    void services.ar.start(room);
  };
  const name = state.scene.name || "My room";
  return html`<p>
      The camera shows your room behind the furniture. No picture leaves this device: only the
      outline and the boxes that you mark.
    </p>
    <div class="ways-in">
      ${button({ icon: "room", label: "Start in a new room", run: begin("new") }, "primary")}
      ${button({ icon: "check", label: `I am in “${name}”`, run: begin("known") })}
    </div>`;
}

/** In place of the cameras: what hides what, where the room is, the way out. */
export function arControls({ state, services, dispatch }: Page, ar: Ar): TemplateResult {
  return html`<div class="cameras ar-controls" role="group" aria-label="Camera view">
    ${toolButton({
      icon: "hide",
      label: "Hide",
      keys: "O",
      pressed: ar.occlusion,
      run: () => dispatch({ type: "change-ar", change: { occlusion: !ar.occlusion } }),
    })}
    ${toolButton({ icon: "corner", label: "Line up", run: () => services.ar.lineUp() })}
    ${
      canCapture(state)
        ? toolButton({ icon: "room", label: "Scan", run: () => services.ar.capture() })
        : nothing
    }
    ${
      state.scene.boxes.length === 0 || ar.room === "new"
        ? nothing
        : toolButton({ icon: "turn-right", label: "Turn", run: () => services.ar.turnRound() })
    }
    ${toolButton({ icon: "close", label: "End", keys: "V", run: () => services.ar.end() })}
  </div>`;
}

/** The big button at the thumb: it does what a tap in the middle of the view does. */
export function markButton({ state, services, dispatch }: Page): TemplateResult | typeof nothing {
  const { ar, draft } = state;
  const label = ar === null ? null : markInWords(state, ar);
  if (label === null) return nothing;
  const closable = draft?.kind === "room" && draft.corners.length >= 3;
  return html`<div class="marks">
    ${button({ icon: "check", label, keys: "Enter", run: () => services.ar.mark() }, "primary")}
    ${
      closable
        ? button({
            icon: "room",
            label: "Close it",
            run: () => dispatch({ type: "close-outline" }),
          })
        : nothing
    }
  </div>`;
}

/** What the sheet holds in the camera view beyond what it holds elsewhere; null for that alone. */
export function arPanel(page: Page, ar: Ar): TemplateResult | null {
  if (ar.found !== null) return offer(page, ar);
  if (ar.unchecked.length > 0) return check(page, ar);
  return page.state.tool === "select" ? null : marking(page, ar);
}

function offer({ dispatch }: Page, ar: Ar): TemplateResult {
  const outline = ar.found?.corners ? "Its walls are known too." : "Draw its walls first or after.";
  return section(
    foundInWords(ar),
    html`<p>Your device knows this room. ${outline}</p>
      <div class="row">
        ${button({ icon: "check", label: "Use them", run: () => dispatch({ type: "use-found" }) }, "primary")}
        ${button({ icon: "close", label: "I draw it myself", run: () => dispatch({ type: "change-ar", change: { found: null } }) })}
      </div>`,
    "found",
  );
}

/** One piece after the other: keep it, put it right, or drop it. */
function check(page: Page, ar: Ar): TemplateResult {
  const { state, dispatch, change } = page;
  const box = state.scene.boxes.find(({ id }) => id === ar.unchecked[0]);
  const verdict = (keep: boolean) => (): void => dispatch({ type: "check-piece", keep });
  const left = ar.unchecked.length;
  return section(
    `Is this a ${inSentence(box?.category ?? "Other")}?`,
    html`<div class="row">
        ${button({ icon: "check", label: "Keep", run: verdict(true) }, "primary")}
        ${button({ icon: "select", label: "Fix", run: () => change({ sheet: "half" }) })}
        ${button({ icon: "remove", label: "Drop", run: verdict(false) })}
      </div>
      <div class="row">
        <span class="quiet">${left} to look at</span>
        ${button({ icon: "check", label: "Keep all", run: () => dispatch({ type: "change-ar", change: { unchecked: [] } }) }, "quiet")}
      </div>
      ${box === undefined || page.local.sheet !== "peek" ? selectionPanel(page) : labels(page, box.id)}`,
    "checking",
  );
}

/** How corners are marked, and what was marked last. */
function marking(page: Page, ar: Ar): TemplateResult {
  const { state, dispatch } = page;
  const done = button({
    icon: "close",
    label: state.draft === null || state.tool === "room" ? "Done" : "Start over",
    keys: "Esc",
    run: () =>
      dispatch({
        type: "choose-tool",
        tool: state.draft === null || state.tool === "room" ? "select" : state.tool,
      }),
  });
  const selected = state.selection?.kind === "box" ? state.selection.id : null;
  return html`<section class="part drawing" aria-label="Marking">
    ${selected === null ? nothing : labels(page, selected)}
    <div class="row">${done} ${ways(page, ar)}</div>
  </section>`;
}

function ways({ state, dispatch }: Page, ar: Ar): TemplateResult | typeof nothing {
  const set = (change: Partial<Ar>) => (): void => dispatch({ type: "change-ar", change });
  switch (state.tool) {
    case "room":
      return html`${button({
        icon: "undo",
        label: "Last corner",
        keys: "Del",
        disabled: state.draft?.kind !== "room" || state.draft.corners.length === 0,
        run: () => dispatch({ type: "remove-last-corner" }),
      })}
      ${button({ icon: "corner", label: "Square", pressed: ar.square, run: set({ square: !ar.square }) })}`;
    case "box":
      return button({
        icon: "corner",
        label: ar.marks === 3 ? "By 3 corners" : "By 2 corners",
        run: set({ marks: ar.marks === 3 ? 2 : 3 }),
      });
    case "door":
    case "window":
    case "select":
      return nothing;
  }
}

/** What a box is, the likely ones first. */
function labels({ state, dispatch }: Page, id: string): TemplateResult | typeof nothing {
  const box = state.scene.boxes.find((one) => one.id === id);
  if (box === undefined) return nothing;
  return chips(
    "What is it?",
    likelyCategories(box.size, state.lists.categories),
    box.category,
    (category) => dispatch({ type: "edit-box", box: { ...box, category }, done: true }),
  );
}
