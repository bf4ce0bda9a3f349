/** How things move: shortly, and not at all for people who asked for that. */

const asked = globalThis.matchMedia?.("(prefers-reduced-motion: reduce)");

export function reducedMotion(): boolean {
  return asked?.matches ?? false;
}

/** From 0 to 1, fast at first, gently at the end. */
export function easeOut(t: number): number {
  return 1 - (1 - t) ** 3;
}

/** The number one step nearer to its goal: all the way in about `seconds`. */
export function approach(value: number, goal: number, elapsed: number, seconds: number): number {
  if (reducedMotion()) {
    return goal;
  }
  const step = elapsed / seconds;
  return Math.abs(goal - value) <= step ? goal : value + Math.sign(goal - value) * step;
}
