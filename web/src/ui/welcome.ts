/** The first minute: one sentence and one button, then three doors. */
import { html, nothing, type TemplateResult } from "lit";
import { shownRefusal } from "../model/ghost";
import { button, iconButton, toolButton } from "./controls";
import { wayOut } from "./instead";
import { openJoin } from "./join";
import type { Page } from "./page";
import { start } from "./place";
import { verdictOf } from "./reasons";
import { ended, isNow } from "./words";

/** Whether the card of the first minute is there. */
export function isGuided({ state, local }: Page): boolean {
  if (state.ar !== null) return state.ar.step !== "ready";
  return local.guide === "invite" ? state.scene.boxes.length > 0 : local.guide !== "done";
}

export function welcome(page: Page): TemplateResult | typeof nothing {
  if (page.state.ar !== null) return nothing;
  switch (page.local.guide) {
    case "invite":
      return page.state.scene.boxes.length === 0 ? nothing : invitation(page);
    case "placing":
      return settling(page);
    case "doors":
      return doors(page);
    case "done":
      return nothing;
  }
}

function invitation(page: Page): TemplateResult {
  return card(
    page,
    html`<p>Where would a sofa go in this room, which way should it face, and why?</p>
      ${button(
        {
          icon: "check",
          label: "Put a sofa in this room",
          run: () => {
            page.change({ guide: "placing" });
            page.dispatch({ type: "touched" });
            start(page, "Sofa", null, null, "scenegen");
          },
        },
        "primary",
      )}`,
  );
}

function settling(page: Page): TemplateResult {
  const { placing } = page.state;
  const sentence = placing === null ? null : verdictOf(placing)?.sentence;
  const problem = shownRefusal(page.state) ?? placing?.answer?.no_good_place?.text;
  if (placing === null || !sentence) {
    return card(page, html`<p>${problem ?? "Looking round the room…"}</p>${wayOut(page)}`);
  }
  const places = placing.answer?.placements ?? [];
  const at = places.findIndex(({ rank }) => rank === placing.alternative);
  const next = places[(at + 1) % places.length];
  return card(
    page,
    html`<p>${ended(sentence)}</p>
      <div class="row">
        ${button({ icon: "check", label: "Place it", run: () => page.dispatch({ type: "confirm" }) }, "primary")}
        ${
          next === undefined || places.length < 2
            ? nothing
            : button({
                icon: "again",
                label: "Another place",
                run: () => page.dispatch({ type: "show-alternative", rank: next.rank }),
              })
        }
      </div>`,
  );
}

function doors(page: Page): TemplateResult {
  return card(
    page,
    html`<p>${isNow("Sofa", page.local.placed?.sentence ?? "")} What now?</p>
      <div class="doors">
        ${toolButton({
          icon: "hand",
          label: "Try it yourself",
          run: () => {
            page.change({ guide: "done" });
            start(page, "Chair", null, null, "manual");
          },
        })}
        ${toolButton({
          icon: "room",
          label: "Draw your own room",
          run: () => {
            page.change({ guide: "done" });
            page.dispatch({ type: "new-room" });
          },
        })}
        ${phoneDoor(page)} ${cameraDoor(page)}
      </div>`,
  );
}

function phoneDoor(page: Page): TemplateResult {
  return html`<span class="desk-only">${toolButton({
    icon: "phone",
    label: "Use your phone",
    run: () => openJoin(page),
  })}</span>`;
}

/** Whoever holds the phone already goes on with its camera. */
function cameraDoor({ change }: Page): TemplateResult {
  return html`<span class="phone-only">${toolButton({
    icon: "phone",
    label: "Use the camera",
    run: () => change({ arDoor: true }),
  })}</span>`;
}

function card(page: Page, content: TemplateResult): TemplateResult {
  return html`<section class="card welcome" aria-label="First steps">
    ${content}
    ${iconButton({ icon: "close", label: "Close", run: () => page.change({ guide: "done" }) })}
  </section>`;
}
