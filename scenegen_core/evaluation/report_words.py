"""The sentences of the report."""

from __future__ import annotations

from scenegen_core.evaluation.names import (
    BOUND,
    MEASURES,
    ORIENTATION_SYSTEMS,
    POSITION_SYSTEMS,
    REFERENCE,
)
from scenegen_core.evaluation.published import ORIENTATION, POSITION
from scenegen_core.evaluation.report_tables import Judged
from scenegen_core.knowledge.knowledge import MIN_EXAMPLES

TASK_WORDS = {
    "joint": "An object is taken out of its room; each system says where it goes and which way it "
    "faces. This is what the program is asked to do, and what it should be judged by.",
    "emptier": "With the object its nearest neighbor is taken out, or the nearest two (by the gap "
    "between footprints), and the same is asked of the object alone: less is left of what the "
    "answer hangs on. Asked of a random half of the objects that share their room with two more.",
    "calibration": "A system that gives probabilities should be right about them. A place is the "
    "floor within 0.5 m of an offered pose; it is called with the probability of all possible "
    "poses there, and holds the truth if the object stood there. Of the places called 20 %, a "
    "fifth should.",
    "position": "The paper's first task. The true heading is given, which tells much about the "
    "place: a bed that faces a wall's normal stands at that wall.",
    "orientation": "The paper's second task: at the true place, which way does it face? Only of "
    "what has a front that is known. A guess is 1.57 rad off on average.",
    "yardsticks": "The same tasks by means that know less. The best of the poses tried knows the "
    "truth: it shows what the grid of poses costs.",
    "sources": "Rooms differ: real flats, rooms made by artists, example homes.",
    "reach": (
        "No system can be right where no possible pose was tried near the truth: real rooms break "
        "the hard facts, and boxes are rough. So the task once more, for the objects that could "
        "have been offered right and for the others."
    ),
    "facts": "How often the best pose (place and heading both unknown) breaks a fact that no score "
    "should outweigh, measured apart from the rules that keep poses possible. The true places "
    "break some too: real rooms are cramped, and boxes are rough.",
}

FIVES = (
    "“Nearest of the best 5” is the paper's: its five best are neighbors on the grid. “Nearest of "
    "5 that differ” takes five at least 0.75 m apart, as the program offers them."
)

DENSITIES = (
    "The paper's model gives densities and calls them no probabilities; here they are scaled to "
    "add up to 1 over the possible poses of a room."
)

COMPARABLE = tuple(
    """\
The paper's rooms are those of Matterport3D, which may not be passed on; ours are others. Metres \
grow with rooms: never set our metres beside the paper's alone.
What can be compared: how much an error falls from a reduced system to a fuller one, the order of \
the systems, and skill.
The paper samples about 250 poses a room; here every system chooses among the same possible poses, \
on a finer grid.
The five best of a full system are neighbors on the grid. Where scores tie, the five are drawn at \
random and so lie apart: RP alone knows a handful of scores, which makes its nearest of the best 5 \
small. Of five that differ, all systems' lie apart.
Intervals are 95 %, from drawing the rooms again 1,000 times; objects of one room hang together.\
""".splitlines()
)


def what_was_judged(judged: Judged) -> tuple[str, ...]:
    """Data, folds, seed, what was left out."""
    settings = judged.settings
    rooms, queries = judged.results["rooms"], judged.results["queries"]
    sentences = [f"{queries} objects in {rooms} rooms from {', '.join(settings.data)}."]
    if settings.folds:
        sentences.append(
            f"{settings.folds} folds take turns: a fold is asked with what the others teach. No "
            "home, and no copy of a layout, is in two folds."
        )
    else:
        sentences.append(f"Asked with what was learned from {', '.join(settings.learned)}.")
    if settings.taught:
        sentences.append(
            f"{settings.taught} of these rooms have taught that knowledge: the numbers flatter it."
        )
    sentences += [
        f"{name}: {count} objects not asked, for less than {MIN_EXAMPLES} examples to learn from."
        for name, count in settings.left_out.items()
    ]
    return (*sentences, f"Seed {settings.seed}, version {settings.version}.")


def headline(judged: Judged) -> list[str]:
    """The joint task in one sentence a system that competes."""
    chance = judged.means(REFERENCE, "joint")
    sentences = []
    for name in ("scenegen", "paper"):
        found = judged.means(name, "joint")
        if found:
            sentences.append(
                f"“{name}” puts an object {found['top1']:.2f} m from where it stood, and the "
                f"nearest of five offers {found['spread5']:.2f} m"
                + (f", {found['angle']:.2f} rad off" if "angle" in found else "")
                + "."
            )
    bound = judged.means(BOUND, "joint")
    if chance:
        sentences.append(
            f"Chance among possible poses: {chance['top1']:.2f} m and {chance['spread5']:.2f} m"
            + (f", {chance['angle']:.2f} rad" if "angle" in chance else "")
            + (f"; the best of the poses tried: {bound['top1']:.2f} m." if bound else ".")
        )
    return sentences


def ordering(judged: Judged) -> str:
    """The order of the ablations, here and in the paper."""
    published = {name: values["overall"] for name, values in POSITION.items()}
    sentences = []
    for rank, measure in enumerate(("top1", "top5")):
        ours = {
            word: found[measure]
            for name, word in POSITION_SYSTEMS.items()
            if (found := judged.means(name, "position"))
        }
        theirs = {name: values[rank] for name, values in published.items() if name in ours}
        sentences.append(_order(f"Place, {MEASURES[measure]}", ours, theirs))
    ours = {
        word: found["angle"]
        for name, word in ORIENTATION_SYSTEMS.items()
        if (found := judged.means(name, "orientation"))
    }
    theirs = {name: ORIENTATION[name]["overall"] for name in ours}
    sentences.append(_order("Heading", ours, theirs))
    return " ".join(filter(None, sentences))


def _order(what: str, ours: dict[str, float], theirs: dict[str, float]) -> str:
    if len(ours) < 2:  # noqa: PLR2004 (one alone has no order)
        return ""
    here, there = (", ".join(sorted(found, key=found.__getitem__)) for found in (ours, theirs))
    if here == there:
        return f"{what}: from best to worst {here}, here as in the paper."
    return f"{what}: from best to worst {here}; in the paper {there}."
