"""``scenegen place``: where would it go? Answers in words, as JSON, as pictures and models."""

from __future__ import annotations

import re
import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from math import degrees, radians
from pathlib import Path
from time import perf_counter
from typing import Any

import msgspec

from scenegen_core.errors import SceneError
from scenegen_core.knowledge import Knowledge, default_knowledge, load_knowledge
from scenegen_core.placement.answer import MODELS, Answer, HeatMap, Query
from scenegen_core.placement.arrange import arrange
from scenegen_core.scene.model import Scene, Vector3
from server.commands.questions import Asked, remedy, what_if, why_not
from server.commands.rooms import open_room

DECIMALS = 4  # of metres and radians that are printed


def add_arguments(parser: ArgumentParser) -> None:
    """Declare what the command takes."""
    parser.add_argument("room", type=Path, metavar="ROOM", help="a file of rooms, of any format")
    parser.add_argument(
        "--add",
        action="append",
        required=True,
        type=wish,
        metavar="CATEGORY[:D,W,H]",
        help="what to place, with its depth, width, height in metres; again for more objects",
    )
    parser.add_argument("--room-id", metavar="ID", help="which room of a file of several")
    parser.add_argument("--model", choices=MODELS, default=MODELS[0])
    parser.add_argument("--count", type=_count, default=5, help="alternatives to offer (1 to 10)")
    parser.add_argument("--seed", type=_seed, default=0, help="decides between equal scores")
    parser.add_argument("--knowledge", type=Path, metavar="FILE", help="instead of the shipped one")
    parser.add_argument(
        "--why-not",
        type=spot,
        metavar="X,Y[,DEGREES]",
        help="say of that spot why the last object should not go there, and what it would take",
    )
    parser.add_argument(
        "--what-if", action="store_true", help="say which thing matters most to the last object"
    )
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--heat-map", type=Path, metavar="FILE.png", help="draw the last heat map")
    parser.add_argument("--glb", type=Path, metavar="FILE.glb", help="save the furnished room")


def run(arguments: Namespace) -> int:
    """Place, print, save."""
    scene = open_room(arguments.room, arguments.room_id)
    knowledge = load_knowledge(arguments.knowledge) if arguments.knowledge else default_knowledge()
    queries = [_query(name, size, arguments, knowledge) for name, size in arguments.add]
    started = perf_counter()
    furnished, answers = arrange(scene, queries, knowledge)
    elapsed = (perf_counter() - started) * 1000
    last = Asked(_before_the_last(furnished, answers[-1]), queries[-1], knowledge)
    extra = [
        *([remedy(last)] if answers[-1].no_good_place else []),
        *([why_not(last, *arguments.why_not)] if arguments.why_not else []),
        *([what_if(last)] if arguments.what_if else []),
    ]
    if arguments.json:
        told = report(scene, arguments.model, answers, elapsed)
        for more in extra:
            told |= more.data
        print(msgspec.json.encode(told).decode())
    else:
        lines = [line for answer in answers for line in _told(answer)]
        print("\n".join([*lines, *(line for more in extra for line in more.lines)]))
    _save(arguments, furnished, answers[-1])
    return 0


def wish(text: str) -> tuple[str, Vector3 | None]:
    """A category and perhaps a size: "sofa" or "sofa:0.9,2.1,0.8"."""
    name, _, sizes = text.partition(":")
    if not sizes:
        return name, None
    try:
        depth, width, height = (float(part) for part in sizes.split(","))
    except ValueError:
        raise ArgumentTypeError(
            f"{text!r}: write the size as depth,width,height in metres, like sofa:0.9,2.1,0.8"
        ) from None
    return name, (depth, width, height)


def spot(text: str) -> tuple[float, float, float]:
    """A spot on the floor in metres, and a heading in degrees: "1.2,0.5,90"."""
    try:
        x, y, *turn = (float(part) for part in text.split(","))
        (degrees,) = turn or (0.0,)
    except ValueError:
        raise ArgumentTypeError(
            f"{text!r}: write the spot as x,y in metres and perhaps a heading, like 1.2,0.5,90"
        ) from None
    return x, y, radians(degrees)


def _before_the_last(furnished: Scene, last: Answer) -> Scene:
    """The room as the last object found it."""
    return furnished.without(furnished.boxes[-1].id) if last.poses else furnished


def report(scene: Scene, model: str, answers: tuple[Answer, ...], elapsed: float) -> dict[str, Any]:
    """All answers as one plain object."""
    return {
        "room_id": scene.id,
        "model": model,
        "answers": [_answer(answer) for answer in answers],
        "elapsed_ms": round(elapsed, 1),
    }


def _answer(answer: Answer) -> dict[str, Any]:
    none = answer.no_good_place
    return {
        "category": answer.category,
        "size": _rounded(answer.size),
        "placements": [
            {
                "rank": pose.rank,
                "center": _rounded(pose.center),
                "yaw": round(pose.heading, DECIMALS),
                "score": pose.score,
                "likelihood": round(pose.likelihood, DECIMALS),
                "name": pose.name,
                "sentence": pose.sentence,
                "reasons": [
                    {
                        "relation": reason.relation,
                        "group": reason.group,
                        "contribution": reason.contribution,
                        "text": reason.text,
                    }
                    for reason in pose.reasons
                ],
                "rooms": list(pose.rooms),
            }
            for pose in answer.poses
        ],
        "heat_map": _heat_map(answer.heat_maps[0]),
        "heat_maps": [_heat_map(heat_map) for heat_map in answer.heat_maps],
        "no_good_place": None if none is None else {"rule": none.rule, "text": none.text},
    }


def _heat_map(heat_map: HeatMap) -> dict[str, Any]:
    return {
        "surface": heat_map.surface,
        "origin": _rounded(heat_map.origin),
        "cell": heat_map.cell,
        "shape": list(heat_map.values.shape),
        "min": heat_map.low,
        "max": heat_map.high,
    }


def _rounded(values: tuple[float, ...]) -> list[float]:
    return [round(value, DECIMALS) for value in values]


def _query(name: str, size: Vector3 | None, arguments: Namespace, knowledge: Knowledge) -> Query:
    known = {category.lower(): category for category in knowledge.categories}
    if name.lower() not in known:
        raise SceneError(
            f"{name!r} is no category that can be placed; use one of {', '.join(known.values())}."
        )
    return Query(
        known[name.lower()],
        size=size,
        count=arguments.count,
        model=arguments.model,
        seed=arguments.seed,
    )


def _count(text: str) -> int:
    if not re.fullmatch(r"[1-9]|10", text):
        raise ArgumentTypeError(f"{text!r}: give a number from 1 to 10")
    return int(text)


def _seed(text: str) -> int:
    if not re.fullmatch(r"\d{1,18}", text):
        raise ArgumentTypeError(f"{text!r}: give a whole number from 0 on as the seed")
    return int(text)


def _told(answer: Answer) -> list[str]:
    """The answer in words, a line a placement."""
    depth, width, height = answer.size
    lines = [f"{answer.category}, {depth:.2f} × {width:.2f} × {height:.2f} m"]
    if answer.no_good_place is not None:
        return [*lines, f"  {answer.no_good_place.text}"]
    for pose in answer.poses:
        x, y, z = pose.center
        lines.append(
            f"  {pose.rank}  {pose.name}: at ({x:.2f}, {y:.2f}, {z:.2f}), "
            f"heading {degrees(pose.heading):.0f}°: {pose.sentence}"
        )
    best = answer.poses[0]
    lines.append(f"  Rooms that speak for the first: {', '.join(best.rooms)}")
    return lines


def _save(arguments: Namespace, furnished: Scene, last: Answer) -> None:
    """Write the pictures and models that were asked for; drawing is imported only then."""
    if arguments.heat_map:
        from server.heat_map_png import heat_map_png  # noqa: PLC0415

        _write(arguments.heat_map, heat_map_png(furnished, last))
    if arguments.glb:
        from server.furniture import furniture_glb  # noqa: PLC0415
        from server.room_model import room_glb  # noqa: PLC0415

        glb = room_glb(furnished, lambda box: furniture_glb(box.category, box.size, box.label))
        _write(arguments.glb, glb)


def _write(path: Path, content: bytes) -> None:
    try:
        path.write_bytes(content)
    except OSError as error:
        raise SceneError(f"{path} cannot be written: {error.strerror}; choose another.") from None
    print(f"Saved {path}.", file=sys.stderr)
