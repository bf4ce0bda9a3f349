/** The panels round the room: mounted once, rendered anew with every state. */
import "../styles/index.css";
import { html, nothing, render, type TemplateResult } from "lit";
import type { Services, View } from "../contract";
import type { State } from "../model/state";
import type { Dispatch } from "../store";
import { announcement } from "./announcements";
import { arDoor, arPanel, markButton } from "./ar";
import { drawingPanel } from "./drawing";
import { header } from "./header";
import { help } from "./help";
import { createInsets } from "./insets";
import { joinDialog } from "./join";
import { press } from "./keyboard";
import { knowledgeButton, knowledgeDialog } from "./knowledge";
import { layers, layersPanel } from "./layers";
import { follow } from "./local";
import { objectList } from "./objects";
import { INITIAL_LOCAL, type Local, type Page } from "./page";
import { decision, placePanel } from "./place";
import { reasonsPanel } from "./reasons";
import { selectionPanel } from "./selection";
import { sheetHandle } from "./sheet";
import { coaching, nextStep, situation, toast } from "./situation";
import { stepper } from "./stepper";
import { cameras, tools } from "./tools";
import { isGuided, welcome } from "./welcome";

/** What is said waits until nothing newer has come for this long, milliseconds. */
const CALM = 250;

const PANELS = ".bar, .tools, .panel, .cameras, .card, .toast, .marks, .menu, dialog";

/** Shows the panels in the element and listens to the keys of the window. */
export function mountUi(element: HTMLElement, dispatch: Dispatch, services: Services): View {
  let state: State | null = null;
  let local: Local = INITIAL_LOCAL;
  let topic = "";
  const insets = createInsets(element);
  const say = createVoice();
  const pageOf = (state: State): Page => ({ state, local, services, dispatch, change });
  const panel = (): HTMLElement | null => element.querySelector(".panel");
  const inDialog = (): HTMLElement | null => element.querySelector("dialog[open] button");
  function change(changed: Partial<Local>): void {
    local = { ...local, ...changed };
    if (state !== null) draw(state);
  }
  function draw(state: State): void {
    const focused = element.contains(document.activeElement);
    document.documentElement.toggleAttribute("data-ar", state.ar !== null);
    render(panels(pageOf(state)), element);
    // What had the focus is gone: the dialog or the panel takes it, so that Tab goes on from there.
    if (focused && document.activeElement === document.body) (inDialog() ?? panel())?.focus();
    syncDialog(element, "help", state.help);
    syncDialog(element, "ar-door", local.arDoor);
    syncDialog(element, "join", local.joinDoor);
    syncDialog(element, "knowledge", local.knowledgeOf !== null);
    if (topic !== topicOf(state)) element.querySelector(".parts")?.scrollTo(0, 0);
    topic = topicOf(state);
    insets.watch();
  }
  const onKey = (event: KeyboardEvent): void => {
    if (state === null || !isForTheRoom(event)) return;
    if (press(pageOf(state), event)) event.preventDefault();
  };
  window.addEventListener("keydown", onKey);
  element.addEventListener("beforexrselect", keepFromTheRoom);
  element.replaceChildren(); // the page comes with a picture of its loading
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
      element.removeEventListener("beforexrselect", keepFromTheRoom);
      insets.dispose();
      render(html``, element);
    },
  };
}

/** Everything, in the order in which Tab goes through it. */
export function panels(page: Page): TemplateResult {
  const { state, local } = page;
  const placing = state.placing !== null;
  const drawing = state.tool !== "select";
  const own = state.ar === null ? null : arPanel(page, state.ar);
  return html`
    ${header(page)} ${tools(page)}
    <section class="over" aria-label="The room, in words and switches">
      ${objectList(page)} ${coaching(page)} ${toast(page)} ${cameras(page)} ${layers(page)}
      <div class="lower">${situation(page)} ${nextStep(page)} ${welcome(page)} ${markButton(page)}</div>
    </section>
    <aside class="panel" aria-label="Panel" tabindex="-1" data-sheet=${local.sheet}
      data-guided=${isGuided(page)}>
      ${sheetHandle(page)}
      <div class="parts" data-placed=${local.placed !== null}>
        ${own ?? (drawing ? drawingPanel(page) : nothing)}
        ${own !== null || drawing || placing ? nothing : selectionPanel(page)}
        ${state.placing === null ? nothing : stepper(page, state.placing)}
        ${drawing ? nothing : placePanel(page)} ${reasonsPanel(page)}
        ${state.placing === null ? nothing : knowledgeButton(page, state.placing.category)}
        ${layersPanel(page)}
      </div>
      ${decision(page)}
    </aside>
    ${help(page)} ${knowledgeDialog(page)} ${arDoor(page)} ${joinDialog(page)}
  `;
}

/** A tap on a panel is not one on the room behind it. */
function keepFromTheRoom(event: Event): void {
  const { target } = event;
  if (target instanceof Element && target.closest(PANELS) !== null) event.preventDefault();
}

/** What is pressed already: Enter on it means the room. */
const PRESSED = ".chip, .item, .place-choice, .tools .tool";

/** Keys typed into a field, pressed on a button or while a dialog is open belong there. */
function isForTheRoom({ target, key }: KeyboardEvent): boolean {
  if (document.querySelector("dialog[open]") !== null) return false;
  const on = target as Element;
  if (on.closest("input[type=text], input[type=range], [popover]") !== null) return false;
  if (key.startsWith("Arrow")) return on.closest("input, .handle") === null;
  if (key !== "Enter" && key !== " ") return true;
  const control = on.closest("button, a, summary, input");
  return control === null || control.matches(`:is(${PRESSED})[aria-pressed="true"]`);
}

/** What the panel is about; about something new, as a place of one's own, it is read from the top. */
function topicOf({ tool, placing, selection }: State): string {
  return JSON.stringify([tool, placing?.category, placing?.alternative === null, selection]);
}

function syncDialog(element: HTMLElement, name: string, open: boolean): void {
  const dialog = element.querySelector<HTMLDialogElement>(`dialog.${name}`);
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
