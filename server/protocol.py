"""THE schema of the wire; the TypeScript types and docs/protocol.md are generated from it.

Subprotocol ``scenegen.1``. Control messages are JSON text, a union tagged by ``type``. Heat maps
and models are binary frames: ``u32 little-endian header length | JSON header padded with spaces to
4 bytes | payload``; the headers are the union ``FrameHeader``. All coordinates are in the core
frame: metres, z up, headings in radians anticlockwise from +x.
"""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from scenegen_core.scene.files import (
    MAX_BOXES,
    BoxRecord,
    CenterRecord,
    Identifier,
    RoomRecord,
    SceneRecord,
    SizeRecord,
)

SUBPROTOCOL = "scenegen.1"

Sequence = Annotated[int, Meta(ge=0)]
Revision = Annotated[int, Meta(ge=0)]
Digest = Annotated[str, Meta(pattern="^[0-9a-f]{32}$")]
ModelName = Literal["scenegen", "paper"]
Surface = Literal["floor", "walls", "tops"]
Comfort = Literal["window", "path"]

CLOSE_WRONG_PROTOCOL = 4400
CLOSE_TOO_MANY_ERRORS = 4401
CLOSE_REPLACED = 4402
CLOSE_TOO_MANY_SESSIONS = 4403
MAX_TEXT_BYTES = 1_000_000
MAX_ERRORS = 20
MAX_MESSAGES_A_SECOND = 240
MAX_SESSIONS_AN_ADDRESS = 32


class Message(Struct, frozen=True, tag_field="type", forbid_unknown_fields=True):
    """Base of all messages: its tag says which it is."""


# --- page to server -------------------------------------------------------------------------------


class Hello(Message, frozen=True, tag="hello"):
    """The first message on a socket: start a session, or go on with one.

    What outlives a socket is the scene; asks and watched graphs are sent again after it.
    """

    session: Identifier | None = None
    """The session to resume; None starts a new one."""
    revision: Revision = 0
    """The last revision the page saw acknowledged."""
    assets: tuple[Digest, ...] = ()
    """Models the page already has; they are not sent again."""


class PutScene(Message, frozen=True, tag="put_scene"):
    """Replace everything: a scene was opened, or the page re-uploads after a mismatch."""

    seq: Sequence
    scene: SceneRecord


class PutRoom(Message, frozen=True, tag="put_room"):
    """Replace the outline, doors and windows."""

    seq: Sequence
    room: RoomRecord


class PutBoxes(Message, frozen=True, tag="put_boxes"):
    """Add boxes, or replace those with their ids; all of them, or none if one is refused.

    Sent again and again while a box is dragged, with what stands on it.
    """

    seq: Sequence
    boxes: Annotated[tuple[BoxRecord, ...], Meta(min_length=1, max_length=MAX_BOXES)]


class RemoveBox(Message, frozen=True, tag="remove_box"):
    """Remove a box; removing one that is not there is no error."""

    seq: Sequence
    id: Identifier


class Query(Struct, frozen=True, forbid_unknown_fields=True):
    """What is to be placed, and how."""

    category: Identifier
    size: SizeRecord | None = None
    """Depth, width, height in metres; None for the usual size of the category."""
    item: Identifier | None = None
    """A catalogue item to show; its own size then counts when ``size`` is None."""
    model: ModelName = "scenegen"
    count: Annotated[int, Meta(ge=1, le=10)] = 5
    relaxed: Annotated[tuple[Comfort, ...], Meta(max_length=2)] = ()
    """Rules that do not count this time."""


class Ask(Message, frozen=True, tag="ask"):
    """Keep answering this query after every edit until the next ask; None stops."""

    id: Identifier
    """Chosen by the page; answers carry it."""
    query: Query | None


class Inspect(Message, frozen=True, tag="inspect"):
    """What about this very pose, for the query of the current ask? Newest wins."""

    id: Identifier
    center: CenterRecord
    heading: float


class WhatMatters(Message, frozen=True, tag="what_matters"):
    """Which box matters most to the best place of the current ask? Newest wins; edits end it."""

    id: Identifier
    on: bool = True
    """False: nobody waits for it any more."""


class WatchGraph(Message, frozen=True, tag="watch_graph"):
    """Send the scene graph now and after every edit, or stop."""

    on: bool


class Ping(Message, frozen=True, tag="ping"):
    """Is anybody there?"""

    nonce: Sequence


Edit = PutScene | PutRoom | PutBoxes | RemoveBox
ClientMessage = Hello | Edit | Ask | Inspect | WhatMatters | WatchGraph | Ping


# --- server to page -------------------------------------------------------------------------------


class CategoryInfo(Struct, frozen=True):
    """A category that can be drawn or placed."""

    name: str
    symmetry: Literal["asymmetric", "symmetric", "inside facing"]
    placeable: bool
    """False for Other."""
    size: SizeRecord
    """The usual depth, width, height, metres."""
    examples: int
    """How many examples the knowledge has."""


class CatalogueItem(Struct, frozen=True):
    """A model of the user's own catalogue."""

    id: str
    name: str
    category: str
    size: SizeRecord
    asset: Digest


class RoomInfo(Struct, frozen=True):
    """A sample room that can be opened by URL: /rooms/{id}.json."""

    id: str
    name: str
    kind: Literal["sample", "scan"]
    boxes: int
    area: float


class Welcome(Message, frozen=True, tag="welcome"):
    """The answer to hello."""

    session: str
    revision: Revision
    resumed: bool
    """False: this is a new session (or the old one is unknown): upload what you have."""
    scene: SceneRecord | None
    """What the server holds; None when the page's revision is the same or nothing is held."""
    categories: tuple[CategoryInfo, ...]
    catalogue: tuple[CatalogueItem, ...]
    rooms: tuple[RoomInfo, ...]
    models: tuple[ModelName, ...]


class Ack(Message, frozen=True, tag="ack"):
    """That edit is stored, and made this revision."""

    seq: Sequence
    revision: Revision


class Models(Message, frozen=True, tag="models"):
    """Which model shows which box, for the boxes whose model is new (after hello: all of them).

    The bytes come in binary frames, once per digest.
    """

    revision: Revision
    boxes: dict[str, Digest]


class Reason(Struct, frozen=True):
    """One part of a score; the contributions of a placement add up to its score."""

    relation: str
    group: str
    contribution: float
    text: str


class Placement(Struct, frozen=True):
    """A pose on offer."""

    rank: int
    center: CenterRecord
    heading: float
    score: float
    """Log-likelihood above the average possible spot of this room (nats)."""
    likelihood: float
    """0 to 1 on the scale of the heat map's legend (0 worst, 1 best)."""
    name: str
    """A few words that tell it from the others on offer: "by the window"."""
    sentence: str
    reasons: tuple[Reason, ...]
    rooms: tuple[str, ...]
    """The known rooms that speak loudest for it."""


class Remedy(Struct, frozen=True):
    """The nearest thing that gives a place: a smaller size, one box less, or one rule less."""

    kind: Literal["size", "box", "rule"]
    text: str
    center: CenterRecord
    """Where the object would then go."""
    heading: float
    size: SizeRecord | None
    box: str | None
    """The id of the box to take away."""
    rule: Comfort | None


class NoGoodPlace(Struct, frozen=True):
    """Why there is no place."""

    rule: str
    text: str
    remedy: Remedy | None
    """None until it is found, and if there is none; the answer then comes once more with it."""


class Answer(Message, frozen=True, tag="answer"):
    """The placements for the query of an ask; the heat maps of its revision have come before."""

    ask: str
    revision: Revision
    category: str
    size: SizeRecord
    asset: Digest
    """The model that shows the object."""
    placements: tuple[Placement, ...]
    no_good_place: NoGoodPlace | None
    elapsed_ms: float


class Maps(Message, frozen=True, tag="maps"):
    """The heat maps that came right before it are of this revision; their answer follows.

    Unless the scene changes again first: while a box is dragged, maps come without answers.
    """

    ask: str
    revision: Revision


class Elsewhere(Struct, frozen=True):
    """Another pose, and how to get there."""

    center: CenterRecord
    heading: float
    distance: float
    """Metres from the pose that was inspected."""
    text: str
    """The way in words: "30 cm further from the door"."""
    sentence: str
    """How it stands there."""


class Cost(Struct, frozen=True):
    """What a pose loses to the best one on offer through one relation to a group."""

    relation: str
    group: str
    difference: float
    """Nats, negative."""
    here: str
    best: str


class Inspected(Message, frozen=True, tag="inspected"):
    """What the query's model says of one pose."""

    id: str
    ask: str
    revision: Revision
    allowed: bool
    rule: str
    """The rule that forbids it; empty if none does."""
    score: float | None
    likelihood: float | None
    sentence: str
    """Why here, or why not."""
    reasons: tuple[Reason, ...]
    costs: tuple[Cost, ...]
    """What it loses most by to the best place, the dearest first."""
    elsewhere: Elsewhere | None
    """The nearest pose that is allowed, or one that is better; None if there is none."""


class Weighing(Message, frozen=True, tag="weighing"):
    """How far the search for what matters has come."""

    id: str
    done: int
    total: int


class Counterfactual(Struct, frozen=True):
    """The box whose removal changes the best place most, and the place without it."""

    box: str
    center: CenterRecord | None
    """None if there is no place without it."""
    heading: float | None
    text: str
    moved: float
    """Metres between the best places with and without it."""
    turned: float
    """Radians between them, 0 to π."""
    score_change: float
    """Nats, without it less with it."""


class Matters(Message, frozen=True, tag="matters"):
    """What matters most; nothing if no box alone changes the place."""

    id: str
    ask: str
    revision: Revision
    found: Counterfactual | None


class GraphNode(Struct, frozen=True):
    """A box, a group or the room, as a node of the scene graph."""

    id: str
    kind: Literal["object", "group", "room"]
    name: str
    center: CenterRecord


class GraphEdge(Struct, frozen=True):
    """A relation between two nodes."""

    source: str
    target: str
    relation: str
    value: float
    text: str


class Graph(Message, frozen=True, tag="graph"):
    """The spatial scene graph of the room as it is."""

    revision: Revision
    nodes: tuple[GraphNode, ...]
    edges: tuple[GraphEdge, ...]


class Problem(Message, frozen=True, tag="problem"):
    """Something was refused; says what to do. Nothing else is affected."""

    code: Literal[
        "bad_json", "bad_message", "bad_scene", "bad_query", "too_large", "too_fast",
        "too_many_boxes", "internal",
    ]  # fmt: skip
    text: str
    path: str | None = None
    """Where in the message: ``$.box.size[2]``."""
    seq: Sequence | None = None
    """The edit that was refused, if it was one."""


class Pong(Message, frozen=True, tag="pong"):
    """Yes."""

    nonce: Sequence


ServerMessage = (
    Welcome | Ack | Models | Maps | Answer | Inspected | Weighing | Matters | Graph | Problem | Pong
)  # fmt: skip


# --- binary frames, server to page ----------------------------------------------------------------


class HeatMapHeader(Message, frozen=True, tag="heat_map"):
    """A raster of uint8: 0 nobody can stand there, 1 least to 255 most likely.

    ``floor`` and ``tops``: the plan; row r, column c is the cell whose corner is origin +
    cell * (c, r), so row 0 lies at the smallest y. ``walls``: the walls unrolled from corner 0 on;
    the column runs along the outline, the row upwards from the floor.
    """

    ask: str
    revision: Revision
    surface: Surface
    origin: tuple[float, float]
    cell: float
    shape: tuple[int, int]
    """Rows, columns."""
    min: float
    """The score at value 1."""
    max: float
    """The score at value 255."""


class AssetHeader(Message, frozen=True, tag="asset"):
    """A GLB; y up, origin at the base center (wall objects: back center), front along +z."""

    digest: Digest


FrameHeader = HeatMapHeader | AssetHeader
