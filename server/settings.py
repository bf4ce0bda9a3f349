"""What a server is started with."""

from __future__ import annotations

from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path

from server.generated import ROOT

PAGE = ROOT / "web" / "dist"
STORE = Path("var") / "sessions.sqlite3"
LOCAL_NAMES = ("localhost", "127.0.0.1", "::1")


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """The arguments of ``scenegen serve``."""

    host: str = "127.0.0.1"
    port: int = 8000
    """0 takes any that is free."""
    knowledge: Path | None = None
    """None for the knowledge that ships with the program."""
    catalogue: Path | None = None
    """A directory of GLB files; None for no catalogue."""
    store: Path = STORE
    page: Path = PAGE
    """The built page."""
    workers: int = 1
    """Processes that serve; each loads what it needs."""
    lan: bool = False
    """Whether phones in the same network can join, over HTTPS."""
    cert: Path | None = None
    """A certificate of the user's own (PEM) with its ``key``; None to make one where needed."""
    key: Path | None = None

    @property
    def own_cert(self) -> Path:
        """Where the certificate that the program makes is kept: beside the rooms."""
        return self.store.parent / "certificate.pem"

    @property
    def loopback(self) -> bool:
        """Whether only this machine can reach the server."""
        try:
            return ip_address(self.host).is_loopback
        except ValueError:
            return self.host == "localhost"
