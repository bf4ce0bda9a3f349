"""The main job: a scene and a query in, placements, heat maps and reasons out (Algorithm 1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from scenegen_core.errors import SceneError
from scenegen_core.graph.candidates import Candidates
from scenegen_core.graph.situation import Situation
from scenegen_core.graph.surroundings import Surroundings
from scenegen_core.graph.wording import noun
from scenegen_core.knowledge.knowledge import CategoryKnowledge, Knowledge
from scenegen_core.placement.alternatives import Chosen, choose
from scenegen_core.placement.answer import (
    Answer,
    Cancelled,
    HeatMap,
    Inspection,
    NoGoodPlace,
    Pose,
    Query,
)
from scenegen_core.placement.blocks import AT_ONCE, in_blocks
from scenegen_core.placement.explain import Explainer, reference
from scenegen_core.placement.feasible import ALLOWED, RULES, Space, verdicts
from scenegen_core.placement.heat_map import heat_maps, likelihood, scale
from scenegen_core.placement.inspecting import Inspector
from scenegen_core.placement.models import PlacementModel, model_of
from scenegen_core.placement.names import names
from scenegen_core.placement.proposals import Proposals, propose
from scenegen_core.placement.refusals import no_good_place
from scenegen_core.placement.walking import Walking
from scenegen_core.placement.words import sentence
from scenegen_core.scene.geometry import Floats, Ints, wrapped
from scenegen_core.scene.model import Scene, Vector3

MIN_SIZE, MAX_SIZE = 0.01, 20.0  # metres; nothing smaller or larger is furniture


@dataclass(frozen=True, eq=False)
class Solution:
    """An answer with all that is needed to say more about single poses."""

    answer: Answer
    _inspector: Inspector

    def inspect(self, center: Vector3, heading: float) -> Inspection:
        """What the model says of one pose, or which rule forbids it."""
        pose = (np.array([center], dtype=float), np.array([heading], dtype=float))
        return self._inspector.inspect(Candidates(self.answer.category, self.answer.size, *pose))


@dataclass(frozen=True, eq=False)
class Drawing:
    """The heat maps of a query in a scene, and all that offers are chosen from."""

    maps: tuple[HeatMap, ...]
    _query: Query
    _learnt: CategoryKnowledge
    _model: PlacementModel
    _space: Space
    _proposals: Proposals
    _verdict: Ints
    """The rule that forbids each proposal, or ALLOWED: (n,)."""
    _scores: Floats
    """Of all proposals, −∞ where forbidden: (n,)."""
    _bounds: tuple[float, float]

    def solution(self, *, cancelled: Callable[[], bool] = lambda: False) -> Solution:
        """Offers with their reasons. Raises Cancelled as ``solve`` does."""
        around, proposals, scores = self._space.around, self._proposals, self._scores
        possible = np.flatnonzero(self._verdict == ALLOWED)
        candidates = proposals.candidates[possible]
        walking = Walking(around, counts="path" not in self._query.relaxed)
        explainer = Explainer(self._model, around, candidates) if len(possible) else None
        choice = choose(
            proposals,
            scores,
            walking,
            count=self._query.count,
            rng=np.random.default_rng(self._query.seed),
            keep_going=partial(_keep_going, cancelled),
            expects=self._model.expects,
        )
        answer = Answer(
            category=self._query.category,
            size=candidates.size,
            poses=_poses(proposals, choice, scores, self._bounds, around, explainer, self._learnt),
            heat_maps=self.maps,
            no_good_place=_no_good_place(self._verdict, choice, self._query, candidates.size),
        )
        inspector = Inspector(
            category=self._learnt.category,
            space=self._space,
            walking=walking,
            possible=candidates,
            scores=scores[possible],
            bounds=self._bounds,
            explainer=explainer,
            best=next(iter(answer.poses), None),
        )
        return Solution(answer, inspector)


def solve(
    scene: Scene,
    query: Query,
    knowledge: Knowledge,
    *,
    cancelled: Callable[[], bool] = lambda: False,
) -> Solution:
    """Where the object would go in the scene.

    Raises KnowledgeError if there is too little knowledge of the category, SceneError if the size
    is none, Cancelled as soon as ``cancelled`` says that nobody waits any more.
    """
    return draw(scene, query, knowledge, cancelled=cancelled).solution(cancelled=cancelled)


def draw(
    scene: Scene,
    query: Query,
    knowledge: Knowledge,
    *,
    cancelled: Callable[[], bool] = lambda: False,
) -> Drawing:
    """The heat maps, long before the offers and reasons. Raises what ``solve`` does."""
    learnt = knowledge[query.category]
    size = _size(query, learnt)
    model = model_of(query.model, knowledge, query.category)
    around = Surroundings(scene, knowledge.groups)
    space = Space.of(around, query.relaxed)
    proposals = propose(around, learnt.category, size)
    _keep_going(cancelled)
    situation = Situation(proposals.candidates, around)
    verdict = in_blocks(partial(verdicts, space=space), situation, 4 * AT_ONCE)
    _keep_going(cancelled)
    possible = np.flatnonzero(verdict == ALLOWED)
    scores = _scores(model, proposals, possible, around)
    _keep_going(cancelled)
    if len(possible):
        scores -= scores[possible[reference(possible)]].mean()
    bounds = scale(scores[possible])
    return Drawing(
        maps=heat_maps(proposals, scores, bounds),
        _query=query,
        _learnt=learnt,
        _model=model,
        _space=space,
        _proposals=proposals,
        _verdict=verdict,
        _scores=scores,
        _bounds=bounds,
    )


def _keep_going(cancelled: Callable[[], bool]) -> None:
    if cancelled():
        raise Cancelled


def _size(query: Query, learnt: CategoryKnowledge) -> Vector3:
    size = query.size or learnt.usual_size
    if not all(MIN_SIZE <= length <= MAX_SIZE for length in size):
        raise SceneError(
            f"A {noun(query.category)} cannot be {' × '.join(f'{s:g}' for s in size)} m; "
            f"give depth, width and height between {MIN_SIZE:g} and {MAX_SIZE:g} metres."
        )
    return size


def _scores(
    model: PlacementModel, proposals: Proposals, possible: Ints, around: Surroundings
) -> Floats:
    """The log scores of all proposals, −inf where nobody can stand: (n,)."""
    scores = np.full(len(proposals.candidates), -np.inf)
    if len(possible):
        scores[possible] = model.total(Situation(proposals.candidates[possible], around))
    return scores


def _poses(
    proposals: Proposals,
    choice: Chosen,
    scores: Floats,
    bounds: tuple[float, float],
    around: Surroundings,
    explainer: Explainer | None,
    learnt: CategoryKnowledge,
) -> tuple[Pose, ...]:
    if explainer is None:
        return ()
    poses = []
    shown = likelihood(scores[choice.poses], bounds)
    called = names(Situation(proposals.candidates[choice.poses], around), learnt.category)
    found = zip(choice.poses, shown, called, strict=True)
    for rank, (index, value, name) in enumerate(found, start=1):
        single = proposals.candidates[index : index + 1]
        why = explainer.explain(single)
        x, y, z = single.centers[0].tolist()
        poses.append(
            Pose(
                rank=rank,
                center=(x, y, z),
                heading=round(float(wrapped(single.headings)[0]), 9),  # without rounding dust
                score=why.score,
                likelihood=float(value),
                name=name,
                sentence=sentence(Situation(single, around), learnt.category),
                reasons=why.reasons,
                rooms=why.rooms,
            )
        )
    return tuple(poses)


def _no_good_place(
    verdict: Ints, choice: Chosen, query: Query, size: Vector3
) -> NoGoodPlace | None:
    if len(choice.poses):
        return None
    counts = {rule: int(np.count_nonzero(verdict == index)) for index, rule in enumerate(RULES)}
    counts["path"] = int(np.count_nonzero(verdict == ALLOWED))
    return no_good_place(query.category, size, counts, choice.closed)
