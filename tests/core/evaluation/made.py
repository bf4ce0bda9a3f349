"""Records and rooms made by hand."""

from __future__ import annotations

from scenegen_core.evaluation.bench import Task
from scenegen_core.evaluation.records import Chances, Record, Settings
from scenegen_core.scene.model import Box, Room, Scene

FINE = {"collides": 0.0, "outside": 0.0, "blocks_door": 0.0, "breaks_path": 0.0, "declined": 0.0}


def record(
    number: int,
    errors: dict[str, dict[Task, dict[str, float]]],
    *,
    room: str = "r1",
    category: str = "Bed",
    source: str = "flats",
    truth: dict[str, float] | None = None,
    chances: dict[str, Chances] | None = None,
) -> Record:
    return Record(
        case=f"{source}:{room}#{number}",
        room=f"{source}:{room}",
        source=source,
        category=category,
        fold=0,
        errors=errors,
        chances=chances or {},
        truth=truth or FINE,
    )


def joint(top1: float, spread5: float, **facts: float) -> dict[Task, dict[str, float]]:
    return {"joint": {"top1": top1, "top5": top1, "spread5": spread5, **FINE, **facts}}


SETTINGS = Settings(
    data=("flats.jsonl",),
    learned=(),
    digest="0123456789abcdef",
    folds=2,
    seed=1,
    systems=("paper", "random_open"),
    rooms=2,
    taught=0,
    left_out={"TV": 3},
    version="0.1.0",
)


def bedroom(number: int, *extra: Box) -> Scene:
    """4 m by 3 m: a bed with its head to the wall x = 0, a cupboard at the wall y = 0."""
    shift = number / 20
    return Scene(
        room=Room(corners=((0, 0), (4, 0), (4, 3), (0, 3)), room_type="bedroom"),
        boxes=(
            Box("bed", "Bed", (1.0, 1.9 + shift / 4, 0.25), (2.0, 1.4, 0.5), 0.0),
            Box("cupboard", "Storage", (2.5 + shift, 0.3, 0.9), (0.6, 1.0, 1.8), 1.5708),
            *extra,
        ),
        id=f"home{number}/bedroom",
        source="flats",
    )


TELEVISION = Box("tv", "TV", (3.9, 2.0, 1.0), (0.1, 1.0, 0.6), 3.14159)
