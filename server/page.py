"""The built page as static files."""

from __future__ import annotations

from os import PathLike, stat_result
from pathlib import Path

from starlette.responses import PlainTextResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

NOT_BUILT = """\
The page of SceneGen is not built yet.

Run "make page" in the directory of SceneGen (it needs Node), then reload.
"""
FOREVER = "public, max-age=31536000, immutable"
ALWAYS_ASK = "no-cache"


class BuiltPage(StaticFiles):
    """Files of a directory; it may be built while the server runs."""

    def __init__(self, directory: Path) -> None:
        super().__init__(directory=directory, html=True, check_dir=False)
        self._index = directory / "index.html"

    async def check_config(self) -> None:
        """Nothing: a directory that is not there yet has no files."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """A file, or how to build the page."""
        if path == "." and not self._index.exists():
            return PlainTextResponse(NOT_BUILT, status_code=503)
        return await super().get_response(path, scope)

    def file_response(
        self,
        full_path: str | PathLike[str],
        stat_result: stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        """A file; names with a hash in them are kept forever, the others asked for again."""
        response = super().file_response(full_path, stat_result, scope, status_code)
        hashed = Path(full_path).parent.name == "assets"
        response.headers["Cache-Control"] = FOREVER if hashed else ALWAYS_ASK
        return response
