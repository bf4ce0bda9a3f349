"""How phones join: the addresses to open, the code to scan, and the endpoints for them."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from secrets import token_urlsafe
from typing import TYPE_CHECKING
from urllib.parse import quote

import segno
from starlette.requests import Request
from starlette.responses import JSONResponse, Response

from server.network import ANY, lan_names
from server.security import JOIN
from server.settings import Settings

if TYPE_CHECKING:
    from server.certificate import Certificate

SCAN = "Scan this with a phone in the same network."
NOT_OPEN = "This server is open to its own machine only. For phones, start it with: make run LAN=1"
LONGEST_SESSION = 64  # characters; ours have 16
MARGIN = 4  # modules of white round a code (ISO/IEC 18004)
PRIVATE = {"Cache-Control": "no-store"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Join:
    """The way in from outside of this machine."""

    token: str
    base: str
    """The address of the server, as others reach it: ``https://192.168.1.5:8000``."""
    guide: str | None = None
    """The address of the page that explains the browser's warning; None where none comes."""

    @property
    def address(self) -> str:
        """What to open, token and all. The part after # never leaves the phone unencrypted."""
        return f"{self.guide}/#{self.token}" if self.guide else f"{self.base}/?{JOIN}={self.token}"

    def leading_to(self, session: str) -> str:
        """The address that goes on with the room of a session; empty for a new one."""
        known = quote(session[:LONGEST_SESSION], safe="")
        return f"{self.address}&session={known}" if known else self.address


class Joining:
    """Endpoints for the page to show; only those who are in see them.

    With ``?session=`` the phone goes on with the room of that session.
    """

    def __init__(self, join: Join | None) -> None:
        """None where nobody can join."""
        self._join = join

    async def info(self, request: Request) -> Response:
        """The address to open on a phone, or null and how to get one."""
        body = {"address": None, "text": NOT_OPEN}
        if self._join is not None:
            address = self._join.leading_to(request.query_params.get("session", ""))
            body = {"address": address, "text": SCAN}
        return JSONResponse(body, headers=PRIVATE)

    async def picture(self, request: Request) -> Response:
        """The code to scan as SVG; 404 where nobody can join."""
        if self._join is None:
            return JSONResponse({"text": NOT_OPEN}, status_code=404, headers=PRIVATE)
        picture = io.BytesIO()
        address = self._join.leading_to(request.query_params.get("session", ""))
        code = segno.make(address, micro=False)
        code.save(picture, kind="svg", border=MARGIN, light="#fff", omitsize=True)
        return Response(picture.getvalue(), media_type="image/svg+xml", headers=PRIVATE)


def terminal_code(address: str) -> str:
    """The code to scan, drawn for a terminal."""
    text = io.StringIO()
    segno.make(address, micro=False).terminal(text, border=2, compact=True)
    return text.getvalue()


def way_in(
    settings: Settings,
    certificate: Certificate | None,
    *,
    port: int,
    guide_port: int | None = None,
) -> Join | None:
    """How other machines come in; None if they cannot reach the server."""
    if settings.loopback:
        return None
    host = settings.host
    if host in ANY:
        host = _reached_by(certificate.names if certificate else lan_names())
    scheme = "https" if certificate else "http"
    return Join(
        token=certificate.token if certificate else token_urlsafe(),
        base=f"{scheme}://{bracketed(host)}:{port}",
        guide=f"http://{bracketed(host)}:{guide_port}" if guide_port else None,
    )


def bracketed(host: str) -> str:
    """The host as it stands in an address."""
    return f"[{host}]" if ":" in host else host


def _reached_by(names: Sequence[str]) -> str:
    """Which of a certificate's names to show: an address of this machine if it has one."""
    here = [name for name in lan_names() if name in names]
    named = [name for name in names if "*" not in name]
    return next(iter([*here, *named, *lan_names()]))
