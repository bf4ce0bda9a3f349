"""Learning on other processes and machines: dask.distributed as a mapper."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from typing import Any

from scenegen_core.errors import DataError
from scenegen_core.knowledge.learning import Mapper

LOCAL = "local"
AHEAD = 4  # batches sent a worker ahead of the one that is waited for: bounds the memory
RETRIES = 5  # tries of a batch whose worker died; the same batch gives the same examples


@contextmanager
def dask_mapper(address: str, workers: int, *, patience: str = "10s") -> Iterator[Mapper]:
    """A mapper on the scheduler at ``address``, or on ``workers`` processes here for LOCAL.

    Results come in order whichever worker made them, so the knowledge is the same to the bit. A
    worker that dies costs the time of its batches. DataError if dask or the scheduler is missing.
    """
    try:
        from distributed import Client, LocalCluster  # noqa: PLC0415 (an optional extra)
    except ImportError:
        raise DataError(
            "Learning on dask needs the package distributed; install scenegen with its extra: "
            "pip install 'scenegen[dask]'."
        ) from None
    if address == LOCAL:
        with (
            LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as here,
            Client(here) as client,
        ):
            yield _mapper(client)
        return
    try:
        client = Client(address, timeout=patience)
    except (OSError, ValueError) as error:
        raise DataError(
            f"There is no dask scheduler at {address} ({error}); start one with dask scheduler."
        ) from None
    with client:
        yield _mapper(client)


def _mapper(client: Any) -> Mapper:
    def mapper(function: Any, batches: Iterator[Any]) -> Iterator[Any]:
        ahead = AHEAD * max(1, len(client.scheduler_info()["workers"]))
        waiting = deque(_sent(client, function, islice(batches, ahead)))
        while waiting:
            yield waiting.popleft().result()
            waiting.extend(_sent(client, function, islice(batches, 1)))

    return mapper


def _sent(client: Any, function: Any, batches: Iterator[Any]) -> list[Any]:
    return [client.submit(function, batch, pure=False, retries=RETRIES) for batch in batches]
