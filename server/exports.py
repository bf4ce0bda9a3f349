"""What the page asks for as a file.

What makes the files is slow to import, and imported when the first one is asked for.
"""

from __future__ import annotations

from collections.abc import Callable

import msgspec
from anyio import CapacityLimiter, to_thread
from msgspec import Struct
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

from scenegen_core.errors import SceneError, SceneGenError
from scenegen_core.placement.solve import solve
from scenegen_core.scene.files import SceneRecord, decode_scene, record_of, scene_of, write_scene
from scenegen_core.scene.model import Box, Scene
from server.assets import Assets
from server.edits import Vocabulary, edited, wrong_query
from server.looks import look_of
from server.page import FOREVER
from server.protocol import MAX_TEXT_BYTES, Problem, PutScene, Query
from server.store import Store
from server.translate import query_of
from server.world import World

USDZ = "model/vnd.usdz+zip"
NO_MODEL = "There is no such model; put its box again."
AT_ONCE = 2  # exports in the making; others wait, so that the rooms on screen stay quick


class HeatMapRequest(Struct, frozen=True, forbid_unknown_fields=True):
    """A room and what is to be placed in it."""

    scene: SceneRecord
    query: Query


class Exports:
    """Endpoints: those that take a body limit its size, all work off the event loop."""

    def __init__(self, world: World, store: Store) -> None:
        self._world = world
        self._store = store
        self._limiter = CapacityLimiter(AT_ONCE)

    async def check_scene(self, request: Request) -> Response:
        """A scene file or a device's capture as our scene file; 422 says what is wrong with it."""
        return await self._answer(request, self._checked, "application/json")

    async def room(self, request: Request) -> Response:
        """The furnished room of a scene file as GLB."""
        return await self._answer(request, self._room, "model/gltf-binary")

    async def heat_map(self, request: Request) -> Response:
        """The heat map of a scene and a query as PNG."""
        return await self._answer(request, self._heat_map, "image/png")

    async def model(self, request: Request) -> Response:
        """A model by its hash as USDZ."""
        glb = await model_of(request.path_params["digest"], self._world.assets, self._store)
        content = await to_thread.run_sync(_usdz, glb, limiter=self._limiter)
        return Response(content, media_type=USDZ, headers={"Cache-Control": FOREVER})

    async def placed(self, request: Request) -> Response:
        """All that was placed in the room of a session as USDZ."""
        stored = await self._store.load(request.path_params["session"])
        boxes = [box for box in stored.scene.boxes if box.placed] if stored else []
        if not boxes:
            raise HTTPException(404, "Nothing was placed in this room yet; place something first.")
        content = await to_thread.run_sync(self._placed, boxes, limiter=self._limiter)
        return Response(content, media_type=USDZ, headers={"Cache-Control": "no-store"})

    async def _answer(
        self, request: Request, work: Callable[[bytes], bytes], media_type: str
    ) -> Response:
        body = await _body(request)
        try:
            content = await to_thread.run_sync(work, body, limiter=self._limiter)
        except RecursionError:
            raise SceneError("That is nested too deeply to be a room; save it again.") from None
        return Response(content, media_type=media_type)

    def _placed(self, boxes: list[Box]) -> bytes:
        from server.room_model import boxes_glb  # noqa: PLC0415

        return _usdz(boxes_glb(boxes, self._model))

    def _checked(self, body: bytes) -> bytes:
        from server.captures import read_capture  # noqa: PLC0415

        captured = read_capture(body)
        record = decode_scene(body) if captured is None else record_of(captured)
        return write_scene(_scene(record, self._world.words))

    def _room(self, body: bytes) -> bytes:
        from server.room_model import room_glb  # noqa: PLC0415

        return room_glb(_scene(decode_scene(body), self._world.words), self._model)

    def _heat_map(self, body: bytes) -> bytes:
        from server.heat_map_png import heat_map_png  # noqa: PLC0415

        try:
            wish = msgspec.json.decode(body, type=HeatMapRequest)
        except msgspec.DecodeError as error:
            raise SceneError(f"This is not a room and a query: {error}.") from None
        scene = _scene(wish.scene, self._world.words)
        problem = wrong_query(wish.query, self._world.words)
        if problem is not None:
            raise SceneGenError(problem.text)
        query = query_of(wish.query, self._world.catalogue)
        return heat_map_png(scene, solve(scene, query, self._world.knowledge).answer)

    def _model(self, box: Box) -> bytes:
        assets = self._world.assets
        glb = assets.get(assets.digest(look_of(box)))
        assert glb is not None
        return glb


async def model_of(digest: str, assets: Assets, store: Store) -> bytes:
    """The GLB of that hash, made again if it was made before; HTTPException 404 if it never was."""
    glb = assets.get(digest)
    if glb is None and (look := await store.look(digest)) is not None:
        glb = assets.get(await to_thread.run_sync(assets.digest, look))
    if glb is None:
        raise HTTPException(404, NO_MODEL)
    return glb


def _usdz(glb: bytes) -> bytes:
    from server.usdz import usdz  # noqa: PLC0415

    return usdz(glb)


def _scene(record: SceneRecord, words: Vocabulary) -> Scene:
    """The scene of a record; SceneGenError if a page may not send it."""
    scene = edited(None, PutScene(seq=0, scene=record), words)
    if isinstance(scene, Problem):
        raise SceneGenError(scene.text)
    return scene or scene_of(record)


async def _body(request: Request) -> bytes:
    """The body of a request, 413 as soon as it is too large."""
    body = bytearray()
    async for chunk in request.stream():
        body += chunk
        if len(body) > MAX_TEXT_BYTES:
            text = f"The file is larger than {MAX_TEXT_BYTES // 10**6} MB; send a smaller room."
            raise HTTPException(413, text)
    return bytes(body)
