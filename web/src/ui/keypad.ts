/** Sizes typed on the panel of a device that shows no page: a row to choose from, then a keypad. */
import type { PanelButton } from "../contract";
import type { Action } from "../model/actions";
import { selectedBox } from "../model/selecting";
import { LENGTHS, SIDES, sized, withLength } from "../model/sizes";
import type { State, Typing } from "../model/state";
import { parseLength, shown } from "./lengths";

/** More digits are no length of furniture in centimetres. */
const DIGITS = 4;
const ROWS = ["12345", "67890"] as const;

type Press = (label: string, action: Action, primary?: boolean) => PanelButton;

/** "Depth 90", "Width 200", "Height 80": each opens the keypad. */
export function sizeRow(state: State, press: Press): readonly PanelButton[] {
  const size = state.placing?.size ?? selectedBox(state)?.size;
  if (size === undefined) return [];
  return SIDES.map((side) =>
    press(`${LENGTHS[side]} ${shown(size[side], "cm")}`, typed({ side, digits: "" })),
  );
}

/** "Width: 214 cm", or what to do while nothing is typed. */
export function keypadTitle({ side, digits }: Typing): string {
  const name = LENGTHS[side];
  return digits === "" ? `${name}: type it in centimetres.` : `${name}: ${digits} cm`;
}

export function keypad(
  state: State,
  typing: Typing,
  press: Press,
  dispatch: (action: Action) => void,
): readonly (readonly PanelButton[])[] {
  const { digits } = typing;
  const key = (digit: string): PanelButton =>
    press(digit, typed({ ...typing, digits: (digits + digit).slice(0, DIGITS) }));
  return [
    ...ROWS.map((row) => [...row].map(key)),
    [
      press("Back", typed({ ...typing, digits: digits.slice(0, -1) })),
      press("Cancel", typed(null)),
      { label: "OK", primary: true, run: () => takenOver(state, typing).forEach(dispatch) },
    ],
  ];
}

/** What comes of the typed length; of one that nothing can have, the reason. */
function takenOver(state: State, { side, digits }: Typing): readonly Action[] {
  const length =
    digits === ""
      ? ({ ok: false, problem: "Type a number first." } as const)
      : parseLength(digits, "cm");
  if (!length.ok) return [{ type: "notify", tone: "problem", text: length.problem }];
  const { placing } = state;
  const box = selectedBox(state);
  const done = typed(null);
  if (placing !== null) {
    return [{ type: "set-size", size: withLength(placing.size, side, length.metres) }, done];
  }
  if (box === undefined) return [done];
  return [{ type: "edit-box", box: sized(box, side, length.metres), done: true }, done];
}

const typed = (typing: Typing | null): Action => ({ type: "change-ar", change: { typing } });
