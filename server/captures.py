"""Rooms that devices captured, as a page sends them: JSON of RoomPlan, Quest, MR Utility Kit."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from scenegen_core.datasets.contents import Head
from scenegen_core.datasets.formats import FORMATS
from scenegen_core.datasets.remarks import Remark
from scenegen_core.errors import DataError, SceneError
from scenegen_core.scene.model import Scene

CAPTURES = ("quest", "mruk", "roomplan")
NAME = "Scanned room"
"""What the room is called where the capture does not say."""
NO_ROOM = (
    "There is no room in this file: it is not a scene file, nor a scan of RoomPlan, of a Quest "
    "headset or of MR Utility Kit. Choose one of those."
)


def read_capture(data: bytes) -> Scene | None:
    """The first room of a capture; None if it may be a scene file, SceneError if without a room."""
    if not data.lstrip().startswith(b"{"):
        return None  # archives, too: small ones can unpack to large ones
    with TemporaryDirectory() as directory:
        path = Path(directory) / f"{NAME}.json"
        path.write_bytes(data)
        head = Head(path)
        form = next((form for form in FORMATS if form.recognizes(head)), None)
        if form is None and head.fields:
            raise SceneError(NO_ROOM)
        if form is None or form.name not in CAPTURES:
            return None
        try:
            scene = next(form.read(path, _left_out), None)
        except DataError as error:
            raise SceneError(str(error).replace(str(path), "The file")) from None
    if scene is None:
        raise SceneError("There is no usable room in this scan; scan the room again.")
    return scene


def _left_out(_: Remark) -> None:
    """A person who opens a scan sees what is there."""
