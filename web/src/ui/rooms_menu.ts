/** The menu of rooms: what there is to open, each with its small plan. */
import { html, nothing, type TemplateResult } from "lit";
import { formatArea } from "../model/units";
import type { RoomInfo, SceneRecord } from "../net/protocol.gen";
import { button } from "./controls";
import { icon } from "./icons";
import type { Page } from "./page";
import { plan } from "./plan";
import { counted } from "./words";

const KINDS = [
  { kind: "sample", title: "Sample rooms" },
  { kind: "scan", title: "Scans of real rooms" },
] as const;

export function roomsMenu(page: Page): TemplateResult {
  const { state } = page;
  return html`<div class="menu rooms" id="rooms-menu" popover @toggle=${(event: ToggleEvent) => opened(page, event)}>
    <div class="row files">${fileButtons(page)}</div>
    ${KINDS.map(({ kind, title }) =>
      list(
        page,
        title,
        state.lists.rooms.filter((room) => room.kind === kind),
      ),
    )}
    ${
      state.lists.rooms.length === 0
        ? html`<p class="quiet">Rooms to look at appear here when the connection is there.</p>`
        : nothing
    }
  </div>`;
}

/** A new room, one from a file, this one as a file. */
export function fileButtons({ dispatch, services }: Page): TemplateResult {
  const open = (): void => chooseFile(services.openSceneFile);
  const draw = (): void => {
    dispatch({ type: "new-room" });
    focusRoom();
  };
  return html`
    ${button({ icon: "new", label: "New room", run: closing(draw) })}
    ${button({ icon: "open", label: "Open file…", run: closing(open) })}
    ${button({ icon: "save", label: "Save", keys: "Ctrl S", run: closing(services.saveScene) })}
  `;
}

/** From here on the keys draw; on the button, Enter would begin anew. */
function focusRoom(): void {
  document.querySelector<HTMLElement>("#stage canvas")?.focus();
}

/** Asks the browser for a scene file. */
function chooseFile(open: (file: File) => Promise<void>): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".json,application/json";
  input.onchange = () => {
    const file = input.files?.[0];
    if (file !== undefined) void open(file);
  };
  input.click();
}

function list(
  page: Page,
  title: string,
  rooms: readonly RoomInfo[],
): TemplateResult | typeof nothing {
  if (rooms.length === 0) return nothing;
  return html`<h2>${title}</h2>
    <ul class="room-list">
      ${rooms.map((room) => html`<li>${entry(page, room)}</li>`)}
    </ul>`;
}

function entry({ state, local, services }: Page, room: RoomInfo): TemplateResult {
  const drawn = local.plans[room.id];
  return html`<button
    type="button"
    class="room-entry"
    aria-current=${state.scene.id === room.id ? "true" : nothing}
    @click=${closing(() => services.openRoom(room.id))}
  >
    ${drawn === undefined ? html`<span class="plan">${icon("room")}</span>` : plan(drawn)}
    <span><b>${room.name}</b><small>${formatArea(room.area)} · ${counted(room.boxes, "piece")}</small></span>
  </button>`;
}

/** Does it, with the menu closed. */
function closing(run: () => unknown): () => void {
  return () => {
    document.getElementById("rooms-menu")?.hidePopover();
    run();
  };
}

/** Fetches the plans that are missing, the first time the menu opens; without them it works too. */
async function opened(page: Page, event: ToggleEvent): Promise<void> {
  if (event.newState !== "open") return;
  const missing = page.state.lists.rooms.filter(({ id }) => !(id in page.local.plans));
  const fetched = await Promise.all(missing.map(({ id }) => fetchPlan(id)));
  const found = fetched.filter((entry) => entry !== null);
  page.change({ plans: { ...page.local.plans, ...Object.fromEntries(found) } });
}

async function fetchPlan(id: string): Promise<readonly [string, SceneRecord] | null> {
  try {
    const response = await fetch(`/rooms/${encodeURIComponent(id)}.json`);
    return response.ok ? [id, (await response.json()) as SceneRecord] : null;
  } catch {
    return null; // offline: the menu shows the names alone
  }
}
