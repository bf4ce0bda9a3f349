"""How much a page and an address may send."""

from __future__ import annotations

from server.limits import Addresses, Allowance


def test_a_second_of_messages_may_come_at_once_and_then_at_the_rate() -> None:
    allowance = Allowance.full(10, now=100.0)
    assert [allowance.take(now=100.0) for _ in range(11)] == [True] * 10 + [False]
    assert [allowance.take(now=100.25) for _ in range(3)] == [True, True, False]


def test_what_is_not_used_for_long_is_not_saved_up() -> None:
    allowance = Allowance.full(10, now=0.0)
    assert [allowance.take(now=3600.0) for _ in range(11)] == [True] * 10 + [False]


def test_sockets_are_counted_by_address_while_they_are_open() -> None:
    addresses = Addresses(1)
    with addresses.enter("a") as first, addresses.enter("b") as other:
        assert (first, other) == (True, True)
        with addresses.enter("a") as second:
            assert not second
    with addresses.enter("a") as again:
        assert again
