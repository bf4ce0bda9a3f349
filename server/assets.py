"""Models by the hash of their bytes."""

from __future__ import annotations

from collections import OrderedDict
from hashlib import blake2b
from threading import Lock

from server.catalogue import Catalogue
from server.looks import Look

MAX_BYTES = 128_000_000  # of models kept in memory; the least used go first


def digest_of(glb: bytes) -> str:
    """The name of a model: 32 hex digits of the BLAKE2 hash of its bytes."""
    return blake2b(glb, digest_size=16).hexdigest()


class Assets:
    """The catalogue's models, and made ones while they fit; safe to use from several threads.

    What was dropped is made again when it is asked for: the same look gives the same bytes.
    """

    def __init__(self, catalogue: Catalogue, most: int = MAX_BYTES) -> None:
        self._items = {item.id: digest_of(item.data) for item in catalogue.items}
        self._own = {self._items[item.id]: item.data for item in catalogue.items}
        self._most = most
        self._bytes = 0
        self._models: OrderedDict[str, bytes] = OrderedDict()
        self._digests: dict[Look, str] = {}
        self._looks: dict[str, Look] = {}
        self._lock = Lock()

    def digest(self, look: Look) -> str:
        """The model of a look: the catalogue's if it is an item's, else made if it is new."""
        if look.item in self._items:
            return self._items[look.item]
        with self._lock:
            known = self._digests.get(look)
        return known or self._make(look)

    def get(self, digest: str) -> bytes | None:
        """The bytes of a model; None if there never was such a model."""
        if digest in self._own:
            return self._own[digest]
        with self._lock:
            glb = self._models.get(digest)
            if glb is not None:
                self._models.move_to_end(digest)
                return glb
            look = self._looks.get(digest)
        if look is None:
            return None
        self._make(look)
        return self.get(digest)

    def look(self, digest: str) -> Look | None:
        """What a model that was made shows; None for the catalogue's and for unknown ones."""
        with self._lock:
            return self._looks.get(digest)

    def _make(self, look: Look) -> str:
        from server.furniture import furniture_glb  # noqa: PLC0415 (slow to import)

        glb = furniture_glb(look.category, look.metres, look.label)
        digest = digest_of(glb)
        with self._lock:
            self._digests[look], self._looks[digest] = digest, look
            if digest not in self._models:
                self._models[digest] = glb
                self._bytes += len(glb)
            while self._bytes > self._most and len(self._models) > 1:
                _, dropped = self._models.popitem(last=False)
                self._bytes -= len(dropped)
        return digest
