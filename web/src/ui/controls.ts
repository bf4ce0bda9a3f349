/** The small parts that panels are made of. */
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { type IconName, icon } from "./icons";
import { type Limits, parseLength, shown, type Unit } from "./lengths";
import type { Page } from "./page";

export interface Command {
  readonly icon: IconName;
  readonly label: string;
  /** Shown with the label when the pointer rests on it. */
  readonly keys?: string;
  readonly disabled?: boolean;
  readonly pressed?: boolean;
  run(): void;
}

/** A button with an icon alone; its label is its name. */
export function iconButton(command: Command): TemplateResult {
  return html`<button
    type="button"
    class="icon-button"
    aria-label=${command.label}
    aria-pressed=${command.pressed ?? nothing}
    title=${tip(command)}
    ?disabled=${command.disabled ?? false}
    @click=${command.run}
  >
    ${icon(command.icon)}
  </button>`;
}

/** A button with an icon above its word. */
export function toolButton(command: Command): TemplateResult {
  return html`<button
    type="button"
    class="tool"
    aria-pressed=${command.pressed ?? nothing}
    title=${tip(command)}
    ?disabled=${command.disabled ?? false}
    @click=${command.run}
  >
    ${icon(command.icon)}<span>${command.label}</span>
  </button>`;
}

/** A button with an icon and words side by side. */
export function button(command: Command, kind: "plain" | "primary" | "quiet" = "plain") {
  return html`<button
    type="button"
    class="button ${kind}"
    aria-pressed=${command.pressed ?? nothing}
    title=${command.keys === undefined ? nothing : tip(command)}
    ?disabled=${command.disabled ?? false}
    @click=${command.run}
  >
    ${icon(command.icon)}<span>${command.label}</span>
  </button>`;
}

export interface LengthField {
  /** Differs from that of every other field on the page. */
  readonly id: string;
  readonly label: string;
  readonly unit: Unit;
  readonly value: number;
  readonly limits?: Limits;
  /** Metres that the up and down keys add. */
  readonly step: number;
  change(metres: number): void;
}

/** A field for a length; nonsense is not taken, and the words under the field say why. */
export function lengthField(field: LengthField): TemplateResult {
  const take = (input: HTMLInputElement, text: string): void => {
    const typed = parseLength(text, field.unit, field.limits);
    const isNew = text !== shown(field.value, field.unit);
    showProblem(input, typed.ok || !isNew ? "" : typed.problem);
    if (isNew && typed.ok && typed.metres !== field.value) field.change(typed.metres);
  };
  const step = (event: KeyboardEvent): void => {
    if (event.key === "Escape") leave(event.target as HTMLInputElement);
    const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (sign === undefined) return;
    event.preventDefault();
    const step = event.shiftKey ? 0.01 : field.step;
    take(event.target as HTMLInputElement, `${(field.value + sign * step).toFixed(4)} m`);
  };
  /** Without what was typed; the next Escape is for the room. */
  const leave = (input: HTMLInputElement): void => {
    input.value = shown(field.value, field.unit);
    input.blur();
  };
  return html`<div class="field">
    <label for=${field.id}>${field.label}</label>
    <span class="input">
      <input
        id=${field.id}
        type="text"
        inputmode="decimal"
        autocomplete="off"
        aria-describedby="${field.id}-problem"
        .value=${live(shown(field.value, field.unit))}
        @change=${({ target }: Event) => take(target as HTMLInputElement, (target as HTMLInputElement).value)}
        @keydown=${step}
      />
      <span class="unit" aria-hidden="true">${field.unit}</span>
    </span>
    <span class="problem" id="${field.id}-problem" role="alert"></span>
  </div>`;
}

function showProblem(input: HTMLInputElement, problem: string): void {
  input.setAttribute("aria-invalid", String(problem !== ""));
  const words = document.getElementById(`${input.id}-problem`);
  if (words !== null) words.textContent = problem;
}

function tip({ label, keys }: Command): string {
  return keys === undefined ? label : `${label} (${keys})`;
}

/** A titled part of the panel. */
export function section(title: string, content: unknown, name: string): TemplateResult {
  return html`<section class="part ${name}" aria-labelledby="${name}-title">
    <h2 id="${name}-title">${title}</h2>
    ${content}
  </section>`;
}

/** Deletes what is selected. */
export function deleteButton({ dispatch }: Pick<Page, "dispatch">): TemplateResult {
  const run = (): void => dispatch({ type: "delete-selected" });
  return button({ icon: "remove", label: "Delete", keys: "Del", run }, "quiet");
}
