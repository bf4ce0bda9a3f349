"""What a session wants done: values that ``connection.py`` carries out, in order."""

from __future__ import annotations

from dataclasses import dataclass

from scenegen_core.placement.solve import Drawing, Solution
from scenegen_core.scene.model import Scene
from server.looks import Look
from server.protocol import Answer, Inspect, Query, ServerMessage
from server.wire import Binary


@dataclass(frozen=True, slots=True)
class Save:
    """Store the scene; the effects after it wait until that has happened."""

    session: str
    revision: int
    scene: Scene


@dataclass(frozen=True, slots=True)
class Send:
    """Send a message, and ahead of it the frames that belong to it."""

    message: ServerMessage
    frames: tuple[Binary, ...] = ()


@dataclass(frozen=True, slots=True)
class Push:
    """Send the bytes of a model."""

    digest: str


@dataclass(frozen=True, slots=True)
class Furnish:
    """Make the models of these boxes."""

    revision: int
    looks: dict[str, Look]


@dataclass(frozen=True, slots=True)
class Solve:
    """Answer an ask, its heat maps first."""

    ask: str
    query: Query
    revision: int
    scene: Scene


@dataclass(frozen=True, slots=True)
class Offer:
    """Choose places from the heat maps of an ask, and say why."""

    wish: Solve
    drawing: Drawing
    elapsed: float
    """Seconds that the maps took."""


@dataclass(frozen=True, slots=True)
class StopSolving:
    """Nobody waits for the answer any more, nor for a remedy."""


@dataclass(frozen=True, slots=True)
class FindRemedy:
    """Say what would give a place where there is none."""

    query: Query
    scene: Scene
    answer: Answer


@dataclass(frozen=True, slots=True)
class Weigh:
    """Say which box matters most to the best place."""

    question: str
    ask: str
    query: Query
    revision: int
    scene: Scene
    solution: Solution


@dataclass(frozen=True, slots=True)
class StopWeighing:
    """Nobody waits for what matters any more."""


@dataclass(frozen=True, slots=True)
class Examine:
    """Say what the solution thinks of a pose."""

    solution: Solution
    inspect: Inspect
    ask: str
    revision: int


@dataclass(frozen=True, slots=True)
class DrawGraph:
    """Make the scene graph."""

    revision: int
    scene: Scene


Work = Furnish | Solve | Offer | FindRemedy | Examine | Weigh | DrawGraph
"""What takes long: a result comes of it."""
Deed = Send | Push | StopSolving | StopWeighing | Work
"""What is begun at once and waits for nothing."""
Effect = Save | Deed
