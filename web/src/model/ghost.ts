/** The object on its way into the room as a box, and whether it may stand where it is. */
import type { BoxRecord } from "../net/protocol.gen";
import { obstacleOf, obstacleSentence } from "./obstacles";
import type { Placing, Pose, State } from "./state";

/** The id of the ghost as a box; no box of a scene has it. */
export const GHOST = "ghost";

/** What the server says of where the ghost stands now; "unknown" until it has said so. */
export type Word = "yes" | "no" | "unknown";

/** The ghost as a box; null while it stands nowhere. */
export function ghostBox({ placing }: State): BoxRecord | null {
  if (placing === null || placing.pose === null) return null;
  const { category, size, item, pose } = placing;
  const box = { id: GHOST, category, center: pose.center, size, heading: pose.heading };
  return item === null ? { ...box, placed: true } : { ...box, placed: true, item };
}

/** Why the ghost may not stand where it is, as a sentence; null if nobody knows of a reason. */
export function refusalOf(state: State): string | null {
  const { placing } = state;
  const ghost = ghostBox(state);
  if (placing === null || ghost === null) return null;
  const obstacle = obstacleOf(state.scene, ghost, placing.relaxed);
  if (obstacle !== null) return obstacleSentence(obstacle);
  return serverWord(placing) === "no" ? (placing.inspected?.sentence ?? null) : null;
}

/** The refusal to show: while the ghost is dragged the last one stays until the next word is there. */
export function shownRefusal(state: State): string | null {
  const refusal = refusalOf(state);
  if (refusal !== null || !isWordToCome(state)) return refusal;
  const inspected = state.placing?.inspected;
  return inspected?.allowed === false ? inspected.sentence : null;
}

/** What the server says of this very pose, in the room as it is. */
export function serverWord(placing: Placing): Word {
  const { answer, ask, pose, inspected, inspectedPose } = placing;
  if (placing.computing || answer === null || answer.ask !== ask) return "unknown";
  if (placing.alternative !== null) return "yes";
  if (inspected === null || inspected.ask !== ask) return "unknown";
  if (inspected.revision < answer.revision || !isSamePose(pose, inspectedPose)) return "unknown";
  return inspected.allowed ? "yes" : "no";
}

/** Whether the server will say of the ghost's pose what it thinks of it. */
export function isWordToCome(state: State): boolean {
  const { placing, connection } = state;
  if (placing === null || placing.problem !== null) return false;
  return connection.status === "online" && serverWord(placing) === "unknown";
}

export function isSamePose(one: Pose | null, other: Pose | null): boolean {
  if (one === null || other === null) return one === other;
  return (
    one.heading === other.heading && one.center.every((metres, i) => metres === other.center[i])
  );
}
