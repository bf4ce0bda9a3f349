"""The page before the warning: over plain HTTP, it says what the browser will say, and why.

It answers everything with the same bytes: it reads nothing of a request but its end, and the token
to join with stays behind the # of the address, which browsers never send.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

PAGE = Path(__file__).with_name("guide.html")
PATIENCE = 5.0  # seconds for a request and its answer
END = b"\r\n\r\n"  # of the head of a request
HEADERS = """\
HTTP/1.1 200 OK\r
Content-Type: text/html; charset=utf-8\r
Content-Length: {length}\r
Content-Security-Policy: default-src 'none'; style-src 'unsafe-inline'; \
script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r
Referrer-Policy: no-referrer\r
X-Content-Type-Options: nosniff\r
Cache-Control: no-store\r
Connection: close\r
\r
"""


class Reply(asyncio.Protocol):
    """One connection: any request is answered, then it is closed."""

    def __init__(self, answer: bytes) -> None:
        self._answer = answer
        self._end = b""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Wait for a request, not for ever."""
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        self._waits = asyncio.get_running_loop().call_later(PATIENCE, transport.abort)

    def data_received(self, data: bytes) -> None:
        """Answer what ends as a request does."""
        self._end = (self._end + data)[-len(END) :]
        if self._end == END:
            self._transport.write(self._answer)
            self._transport.close()

    def connection_lost(self, _: Exception | None) -> None:
        """Gone, one way or the other."""
        self._waits.cancel()


@asynccontextmanager
async def serving_guide(listener: socket.socket, *, port: int) -> AsyncIterator[None]:
    """Answer on a listening socket meanwhile; ``port`` is that of the page it leads to."""
    page = PAGE.read_text(encoding="utf-8").replace("{port}", str(port)).encode()
    answer = HEADERS.format(length=len(page)).encode() + page
    loop = asyncio.get_running_loop()
    async with await loop.create_server(lambda: Reply(answer), sock=listener):
        yield
