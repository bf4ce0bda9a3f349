"""What a slow reader gets: every command, and of everything else the newest."""

from __future__ import annotations

import asyncio

import pytest

from server.outbox import MAX_WAITING, Frame, Outbox
from server.protocol import (
    Ack,
    Answer,
    AssetHeader,
    Graph,
    HeatMapHeader,
    Inspected,
    Maps,
    Models,
    Pong,
    Problem,
)
from server.wire import Binary, Close


def answer(revision: int) -> Answer:
    return Answer("a", revision, "Sofa", (1.0, 2.0, 0.8), "0" * 32, (), None, 1.0)


def heat_map(revision: int) -> Binary:
    header = HeatMapHeader("a", revision, "floor", (0.0, 0.0), 0.1, (1, 2), 0.0, 1.0)
    return Binary(header, b"\x01\xff")


def model(digit: str) -> Binary:
    return Binary(AssetHeader(digest=digit * 32), b"glTF")


def drained(outbox: Outbox) -> list[tuple[Frame, ...]]:
    """All that waits, in the order it would be sent."""

    async def drain() -> list[tuple[Frame, ...]]:
        units = []
        outbox.put(Pong(nonce=0))  # a mark: commands go first, so it comes behind the others
        while (unit := await outbox.get()) != (Pong(nonce=0),):
            units.append(unit)
        try:
            while True:
                units.append(await asyncio.wait_for(outbox.get(), 0.01))
        except TimeoutError:
            return units

    return asyncio.run(drain())


def test_acknowledgements_and_problems_all_arrive_in_order_before_any_result() -> None:
    outbox = Outbox()
    commands: list[Frame] = [Ack(1, 1), Problem("bad_scene", "no"), Ack(2, 2)]
    for command in commands:
        outbox.put(heat_map(1), answer(1))
        outbox.put(command)
    units = drained(outbox)
    assert units[:3] == [(command,) for command in commands]


def test_newer_maps_take_the_place_of_all_older_ones_and_stay_before_their_answer() -> None:
    outbox = Outbox()
    outbox.put(heat_map(1), heat_map(1), Maps("a", 1))
    outbox.put(answer(1))
    outbox.put(heat_map(2), Maps("a", 2))
    outbox.put(answer(2))
    assert drained(outbox) == [(heat_map(2), Maps("a", 2)), (answer(2),)]


def test_of_graphs_and_inspections_only_the_newest_waits() -> None:
    outbox = Outbox()
    for revision in range(5):
        outbox.put(Graph(revision, (), ()))
        outbox.put(Inspected(str(revision), "a", revision, False, "", None, None, "", (), (), None))
    assert drained(outbox) == [
        (Graph(4, (), ()),),
        (Inspected("4", "a", 4, False, "", None, None, "", (), (), None),),
    ]


def test_models_of_different_boxes_add_up() -> None:
    outbox = Outbox()
    outbox.put(Models(1, {"a": "0" * 32, "b": "1" * 32}))
    outbox.put(Models(2, {"b": "2" * 32}))
    assert drained(outbox) == [(Models(2, {"a": "0" * 32, "b": "2" * 32}),)]


def test_different_models_all_arrive_and_before_a_later_answer() -> None:
    outbox = Outbox()
    outbox.put(model("0"))
    outbox.put(model("1"))
    outbox.put(answer(1))
    assert drained(outbox) == [(model("0"),), (model("1"),), (answer(1),)]


def test_a_close_comes_behind_what_was_to_be_said() -> None:
    outbox = Outbox()
    outbox.put(Problem("bad_json", "no"))
    outbox.put(Close(4401, "enough"))
    assert drained(outbox) == [(Problem("bad_json", "no"),), (Close(4401, "enough"),)]


def test_a_heat_map_cannot_be_sent_without_what_ends_it() -> None:
    with pytest.raises(TypeError, match="travels with the message that ends it"):
        Outbox().put(heat_map(1))


def test_there_is_no_room_while_too_many_commands_wait() -> None:
    async def fill_and_drain() -> list[bool]:
        outbox = Outbox()
        for seq in range(MAX_WAITING):
            outbox.put(Ack(seq, seq))
        waiter = asyncio.create_task(outbox.has_room())
        await asyncio.sleep(0)
        before = waiter.done()
        await outbox.get()
        await waiter
        return [before, waiter.done()]

    assert asyncio.run(fill_and_drain()) == [False, True]
