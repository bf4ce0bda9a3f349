"""Who may talk to the server, and what the page may load: checks and headers for every answer."""

from __future__ import annotations

from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocket

from server.settings import LOCAL_NAMES

POLICY = (
    "default-src 'self'; "
    "connect-src 'self' blob: data:; "  # models are read from memory
    "img-src 'self' blob: data:; "
    "worker-src 'self' blob:; "
    "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "Content-Security-Policy": POLICY,
    "Cross-Origin-Opener-Policy": "same-origin",
    "Permissions-Policy": "camera=(), microphone=(), geolocation=(), xr-spatial-tracking=(self)",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}
STRANGER = "This request comes from another site; open SceneGen by its own address."


class Security:
    """Middleware: refuses sockets and posts of other sites, adds the headers."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on what is allowed."""

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message).update(HEADERS)
            await send(message)

        refusal = JSONResponse({"text": STRANGER}, status_code=403)
        match scope["type"]:
            case "websocket" if not same_site(Headers(scope=scope)):
                await WebSocket(scope, receive, send).send_denial_response(refusal)
            case "http" if scope["method"] == "POST" and not same_site(Headers(scope=scope)):
                await refusal(scope, receive, send_with_headers)
            case "http":
                await self._app(scope, receive, send_with_headers)
            case _:
                await self._app(scope, receive, send)


def same_site(headers: Headers) -> bool:
    """Whether a request comes from the server's own page, from this machine or from no page."""
    origin = headers.get("origin")
    if origin is None:
        return True
    try:
        site = urlsplit(origin)
    except ValueError:
        return False
    return site.netloc == headers.get("host") or site.hostname in LOCAL_NAMES
