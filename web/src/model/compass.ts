/** The eight ways of the plan; north is up. */
const COMPASS = [
  "east",
  "north-east",
  "north",
  "north-west",
  "west",
  "south-west",
  "south",
  "south-east",
];

/** The direction of an angle (anticlockwise from +x, radians); north is +y. */
export function compass(angle: number): string {
  const eighth = Math.round(angle / (Math.PI / 4));
  return COMPASS[((eighth % 8) + 8) % 8] as string;
}
