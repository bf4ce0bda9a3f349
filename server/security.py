"""Who may talk to the server, and what the page may load: checks and headers for every answer."""

from __future__ import annotations

from ipaddress import IPv6Address, ip_address
from secrets import compare_digest
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import HTTPConnection, Request
from starlette.responses import JSONResponse, PlainTextResponse, RedirectResponse, Response
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
NOT_JOINED = (
    "SceneGen runs on another machine here. To join, scan the code that its terminal shows, or "
    "open the whole address beside it. On that machine itself, open the address with localhost."
)
JOIN = "join"
"""The parameter of an address that has the token."""
COOKIE = "scenegen-join"
KEPT = 396 * 24 * 3600  # seconds; as long as a certificate, less than browsers cap cookies at


class Security:
    """Middleware: lets in who may come in, refuses sockets and posts of other sites."""

    def __init__(self, app: ASGIApp, token: str | None = None) -> None:
        """Let in this machine, and those from elsewhere who have the token; None for nobody."""
        self._app = app
        self._token = token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass on what is allowed."""

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message).update(HEADERS)
            await send(message)

        if scope["type"] == "websocket":
            refusal = self._refusal(HTTPConnection(scope), changes=True)
            if refusal is not None:
                await WebSocket(scope, receive, send).send_denial_response(refusal)
                return
        elif scope["type"] == "http":
            request = Request(scope)
            answer = self._welcome(request)
            answer = answer or self._refusal(request, changes=request.method == "POST")
            await (answer or self._app)(scope, receive, send_with_headers)
            return
        await self._app(scope, receive, send)

    def _welcome(self, request: Request) -> Response | None:
        """For who brings the token: a cookie with it, and the same address without it."""
        if not self._same(request.query_params.get(JOIN)):
            return None
        answer = RedirectResponse(request.url.remove_query_params(JOIN), status_code=303)
        answer.set_cookie(
            COOKIE,
            self._token or "",
            max_age=KEPT,
            secure=request.url.scheme == "https",
            httponly=True,
            samesite="lax",  # not strict: the way here leads over the guide, another site
        )
        return answer

    def _refusal(self, connection: HTTPConnection, *, changes: bool) -> Response | None:
        """Why a request is not for us; None if it is."""
        if not (is_local(connection) or self._same(connection.cookies.get(COOKIE))):
            return _refused(connection, NOT_JOINED)
        if changes and not same_site(connection.headers):
            return _refused(connection, STRANGER)
        return None

    def _same(self, token: str | None) -> bool:
        """Whether that is the token; takes as long whatever it is."""
        ours = self._token
        return ours is not None and compare_digest((token or "").encode(), ours.encode())


def is_local(connection: HTTPConnection) -> bool:
    """Whether a request comes from this machine and means it by name.

    What comes through a tunnel, or from a site whose name was made to lead here, has another name.
    """
    try:
        address = ip_address(connection.client.host if connection.client else "")
        name = urlsplit(f"//{connection.headers.get('host', '')}").hostname
    except ValueError:
        return False
    mapped = address.ipv4_mapped if isinstance(address, IPv6Address) else None
    return (mapped or address).is_loopback and name in LOCAL_NAMES


def _refused(connection: HTTPConnection, text: str) -> Response:
    """A refusal that people can read where they are the ones who asked."""
    if "text/html" in connection.headers.get("accept", ""):
        return PlainTextResponse(text, status_code=403)
    return JSONResponse({"text": text}, status_code=403)


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
