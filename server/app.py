"""The routes of the server, nothing else."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import msgspec
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute

from scenegen_core.errors import SceneGenError
from scenegen_core.knowledge.marginals import marginals
from server.engine import Engine
from server.exports import Exports, model_of
from server.joining import Join, Joining
from server.live import Live
from server.page import ALWAYS_ASK, FOREVER, BuiltPage
from server.room_plan import room_plan
from server.security import Security
from server.settings import Settings
from server.store import Store
from server.world import World


def make_app(settings: Settings, world: World, join: Join | None = None) -> Starlette:
    """The application, for this machine only without a join.

    Raises:
        SceneGenError: Its store cannot be opened.
    """
    store, engine = Store(settings.store), Engine()
    live, exports, files = Live(world, store, engine), Exports(world, store), Files(world, store)
    joining = Joining(join)

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        yield
        await engine.close()
        await store.close()

    return Starlette(
        routes=[
            WebSocketRoute("/socket", live.serve),
            Route("/rooms", files.rooms),
            Route("/rooms/{id}.json", files.room),
            Route("/assets/{digest}.glb", files.asset),
            Route("/knowledge.json", files.knowledge),
            Route("/knowledge/rooms/{id:path}.svg", files.plan),
            Route("/scenes/check", exports.check_scene, methods=["POST"]),
            Route("/export/room.glb", exports.room, methods=["POST"]),
            Route("/export/heat-map.png", exports.heat_map, methods=["POST"]),
            Route("/usdz/{digest}.usdz", exports.model),
            Route("/usdz/sessions/{session}.usdz", exports.placed),
            Route("/join.json", joining.info),
            Route("/join.svg", joining.picture),
            Route("/health", files.health),
            Mount("/", BuiltPage(settings.page)),
        ],
        middleware=[Middleware(Security, token=join.token if join else None)],
        exception_handlers={SceneGenError: unusable, HTTPException: failed},
        lifespan=lifespan,
    )


class Files:
    """Endpoints that hand out what the server has loaded."""

    def __init__(self, world: World, store: Store) -> None:
        self._world = world
        self._store = store

    async def rooms(self, _: Request) -> Response:
        """The sample rooms that can be opened."""
        return _json(self._world.lists.rooms)

    async def room(self, request: Request) -> Response:
        """The scene file of a sample room."""
        room = self._world.rooms.get(request.path_params["id"])
        if room is None:
            raise HTTPException(404, "There is no such room; /rooms lists them.")
        return FileResponse(room.path, headers={"Cache-Control": ALWAYS_ASK})

    async def asset(self, request: Request) -> Response:
        """A model by the hash of its bytes."""
        glb = await model_of(request.path_params["digest"], self._world.assets, self._store)
        headers = {"Cache-Control": FOREVER}
        return Response(glb, media_type="model/gltf-binary", headers=headers)

    async def knowledge(self, _: Request) -> Response:
        """What is known of each category, with the counts behind it."""
        return _json(marginals(self._world.knowledge))

    async def plan(self, request: Request) -> Response:
        """The plan of a room that was learned from; ``?category=`` stands out in it."""
        knowledge, name = self._world.knowledge, request.path_params["id"]
        plan = knowledge.plans.get(name)
        if plan is None:
            raise HTTPException(404, "There is no plan of that room in what was learned.")
        source = next((one for one in knowledge.sources if one.id == plan.source), None)
        svg = room_plan(plan, request.query_params.get("category", ""), name, source)
        headers = {"Cache-Control": ALWAYS_ASK}
        return Response(svg, media_type="image/svg+xml", headers=headers)

    async def health(self, _: Request) -> Response:
        """That the server is up."""
        return JSONResponse({"status": "ok"})


async def unusable(_: Request, error: Exception) -> Response:
    """What a person can do something about."""
    return JSONResponse({"text": str(error)}, status_code=422)


async def failed(_: Request, error: Exception) -> Response:
    """A status with a sentence."""
    assert isinstance(error, HTTPException)
    return JSONResponse({"text": error.detail}, status_code=error.status_code)


def _json(value: object) -> Response:
    return Response(msgspec.json.encode(value), media_type="application/json")
