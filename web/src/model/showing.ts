/** What of the scene is shown, and how. */
import type { HeatMap, Shown, State } from "./state";

const NO_MAPS: readonly HeatMap[] = [];

export function show(state: State, change: Partial<Shown>): State {
  return { ...state, shown: { ...state.shown, ...change } };
}

/** The heat maps to be seen: none by hand, nor where nothing is good and a map would be blank. */
export function shownMaps({ placing, shown }: State): readonly HeatMap[] {
  const nowhere = placing?.answer?.placements.length === 0;
  return shown.heat && placing?.mode === "scenegen" && !nowhere ? placing.heatMaps : NO_MAPS;
}

export function toggleRelation(state: State, relation: string): State {
  const { hiddenRelations } = state.shown;
  const hidden = hiddenRelations.includes(relation)
    ? hiddenRelations.filter((other) => other !== relation)
    : [...hiddenRelations, relation];
  return show(state, { hiddenRelations: hidden });
}

/** Esc: the innermost thing that can be left is left. */
export function cancel(state: State): State {
  if (state.help) return { ...state, help: false };
  if (state.beforeDrag !== null) return { ...state, scene: state.beforeDrag, beforeDrag: null };
  if (state.draft !== null || state.tool !== "select") {
    return { ...state, draft: null, tool: "select" };
  }
  if (state.placing !== null) return { ...state, placing: null, probe: null };
  return { ...state, selection: null };
}
