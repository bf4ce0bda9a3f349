"""Bytes to messages and back; what is wrong with a bad frame, in words and with its path."""

from __future__ import annotations

import re
from struct import pack

import msgspec
from msgspec import Struct

from server.protocol import (
    MAX_TEXT_BYTES,
    AssetHeader,
    ClientMessage,
    FrameHeader,
    HeatMapHeader,
    Problem,
    ServerMessage,
)

WHERE = re.compile(r"^(?P<what>.*?)(?: - at `(?P<path>[^`]*)`)?$", re.DOTALL)
TOO_MANY_BOXES = ("$.scene.boxes", "of length <=")


class Binary(Struct, frozen=True):
    """A binary frame on its way to the page."""

    header: AssetHeader | HeatMapHeader
    payload: bytes


class Close(Struct, frozen=True):
    """The end of a socket, behind everything that was to be said on it."""

    code: int
    reason: str
    """A sentence of at most 123 bytes, the most that a close frame holds."""


class _Numbered(Struct, frozen=True):
    """Just enough of a bad edit to say which one it was."""

    seq: int | None = None


def decode(text: str) -> ClientMessage | Problem:
    """The message of a text frame, or what is wrong with it."""
    size = len(text.encode())
    if size > MAX_TEXT_BYTES:
        return Problem(
            code="too_large",
            text=f"That is {size / 1e6:.1f} MB; at most {MAX_TEXT_BYTES / 1e6:.0f} MB fit. "
            "Send a smaller room.",
        )
    try:
        message: ClientMessage = msgspec.json.decode(text, type=ClientMessage)
    except msgspec.ValidationError as error:
        return _invalid(text, str(error))
    except msgspec.DecodeError as error:
        return Problem(code="bad_json", text=f"That is not JSON: {error}. Send whole messages.")
    except RecursionError:
        return Problem(code="bad_json", text="That is nested too deeply; send what pages send.")
    return message


def encode(message: ServerMessage) -> str:
    """The text frame of a message."""
    return msgspec.json.encode(message).decode()


def frame(header: FrameHeader, payload: bytes) -> bytes:
    """A binary frame: ``u32 little-endian header length | padded JSON header | payload``."""
    text = msgspec.json.encode(header)
    text += b" " * (-len(text) % 4)
    return pack("<I", len(text)) + text + payload


def _invalid(text: str, error: str) -> Problem:
    found = WHERE.match(error)
    assert found is not None
    path, what = found["path"] or "$", found["what"].replace("`", "")
    full = path == TOO_MANY_BOXES[0] and TOO_MANY_BOXES[1] in what
    return Problem(
        code="too_many_boxes" if full else "bad_message",
        text=f"{what} at {path}. Correct it and send it again.",
        path=path,
        seq=_sequence(text),
    )


def _sequence(text: str) -> int | None:
    try:
        seq = msgspec.json.decode(text, type=_Numbered).seq
    except (msgspec.DecodeError, RecursionError):
        return None
    return seq if seq is None or seq >= 0 else None
