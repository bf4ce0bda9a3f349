/** The bar on top: which room, undo and redo, the connection, what leaves the page, help. */
import { html, type TemplateResult } from "lit";
import type { Connection } from "../model/state";
import { button, iconButton } from "./controls";
import { icon } from "./icons";
import { joinButton } from "./join";
import type { Page } from "./page";
import { allPlaced } from "./quick_look";
import { fileButtons, roomsMenu } from "./rooms_menu";
import { counted } from "./words";

export function header(page: Page): TemplateResult {
  const { state } = page;
  return html`<header class="bar">
    <h1>SceneGen</h1>
    <button type="button" class="button room-name" popovertarget="rooms-menu">
      <span>${state.scene.name || "My room"}</span>${icon("down")}
    </button>
    ${history(page)}
    <span class="files">${fileButtons(page)}</span>
    <span class="spring"></span>
    ${connection(state.connection)}
    <button type="button" class="button" popovertarget="export-menu">${icon("export")}<span>Export</span></button>
    ${joinButton(page)} ${helpButton(page)}
    ${roomsMenu(page)} ${exportMenu(page)}
  </header>`;
}

/** Undo and redo; on a phone they stand in the row of tools. */
export function history({ state, dispatch }: Page, show = iconButton): TemplateResult {
  return html`<span class="history">
    ${show({
      icon: "undo",
      label: "Undo",
      keys: "Ctrl Z",
      disabled: state.past.length === 0,
      run: () => dispatch({ type: "undo" }),
    })}
    ${show({
      icon: "redo",
      label: "Redo",
      keys: "Ctrl Shift Z",
      disabled: state.future.length === 0,
      run: () => dispatch({ type: "redo" }),
    })}
  </span>`;
}

/** The state of the connection in words. */
export function connectionInWords({ status, unsent, ended }: Connection): string {
  if (ended !== null) return "Ended";
  switch (status) {
    case "connecting":
      return "Connecting…";
    case "online":
      return unsent === 0 ? "Connected" : "Saving…";
    case "offline":
      return unsent === 0 ? "Offline" : `Offline, ${counted(unsent, "change")} waiting`;
  }
}

function connection(connection: Connection): TemplateResult {
  return html`<span class="connection" data-status=${connection.status}>
    <span class="dot" aria-hidden="true"></span><span>${connectionInWords(connection)}</span>
  </span>`;
}

function helpButton({ dispatch }: Page): TemplateResult {
  return iconButton({
    icon: "help",
    label: "Help",
    keys: "?",
    run: () => dispatch({ type: "toggle-help" }),
  });
}

function exportMenu(page: Page): TemplateResult {
  const { state, services, dispatch } = page;
  const closing = (run: () => unknown) => (): void => {
    document.getElementById("export-menu")?.hidePopover();
    run();
  };
  const noMap = (state.placing?.heatMaps.length ?? 0) === 0;
  return html`<div class="menu" id="export-menu" popover>
    ${button({ icon: "box", label: "Room as a 3D model (GLB)", run: closing(services.exportRoom) }, "quiet")}
    ${button(
      {
        icon: "heat",
        label: "Map of likely places (PNG)",
        disabled: noMap,
        run: closing(services.exportHeatMap),
      },
      "quiet",
    )}
    ${noMap ? html`<p class="quiet">The map is there while you place something.</p>` : ""}
    ${allPlaced(page)}
    ${button({ icon: "save", label: "Scene file (JSON)", run: closing(services.saveScene) }, "quiet")}
    <span class="phone-only">
      ${button({ icon: "help", label: "Help", run: closing(() => dispatch({ type: "toggle-help" })) }, "quiet")}
    </span>
  </div>`;
}
