/** What the server says it knows of each category: /knowledge.json, scenegen_core's marginals. */

/** How many of the examples counted hold a thing true. */
export interface Bar {
  readonly label: string;
  readonly count: number;
  /** 0 to 1. */
  readonly share: number;
  /** Of them, with two or more members of the group. */
  readonly several: number;
  /** Of groups: examples whose room has a member of it at all. */
  readonly possible: number;
}

export interface CategoryMarginals {
  readonly category: string;
  readonly examples: number;
  /** Examples whose front is known: those that `facing` and `towards_center` count. */
  readonly fronts: number;
  readonly position: readonly Bar[];
  readonly surrounded_by: readonly Bar[];
  /** Empty for what has no front of its own. */
  readonly facing: readonly Bar[];
  readonly towards_center: readonly Bar[];
}

/** A collection of rooms that knowledge was learned from. */
export interface Source {
  readonly id: string;
  readonly name: string;
  readonly license: string;
  readonly copyright: string;
  readonly rooms: number;
  readonly objects: number;
}

export interface KnowledgeMarginals {
  readonly sources: readonly Source[];
  readonly categories: readonly CategoryMarginals[];
}
