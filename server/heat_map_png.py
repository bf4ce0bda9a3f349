"""A heat map as a picture: the plan of the room, colored, with what stands in it and a legend."""

from __future__ import annotations

from io import BytesIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor, ImageDraw, ImageFont

from scenegen_core.placement.answer import Answer, HeatMap
from scenegen_core.scene.geometry import Floats
from scenegen_core.scene.model import Point, Scene, Vector3

Bytes = NDArray[np.uint8]

CIVIDIS = (
    "#00224e", "#123570", "#3b496c", "#575d6d", "#707173",
    "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838",
)  # fmt: skip
"""Ten even steps of the palette (Nuñez, Anderton and Renslow 2018), readable by everybody."""

SIDE, MARGIN, LEGEND = 1200, 60, 70  # pixels: longer side of the plan, round it, below it
OUTLINE, BAND, LETTER = 5, 24, 20  # pixels: walls, heat along a wall, height of letters
PAPER, INK, WINDOW, FURNITURE, CHOICE = "#ffffff", "#22262b", "#56b4e9", "#8b95a1", "#d55e00"


def heat_map_png(scene: Scene, answer: Answer) -> bytes:
    """A PNG of the room's plan, y up: the heat maps of the answer and its placements on it."""
    plan = _Plan(scene)
    for heat_map in answer.heat_maps:
        if heat_map.surface == "walls":
            plan.along_walls(heat_map)
        else:
            plan.raster(heat_map)
    plan.walls()
    for box in scene.boxes:
        plan.box(box.center, box.size, box.heading, text=box.label or box.category, color=FURNITURE)
    for pose in answer.poses:
        plan.box(pose.center, answer.size, pose.heading, text=str(pose.rank), color=CHOICE)
    plan.legend(f"{answer.category}: unlikely", "likely")
    return plan.png()


class _Plan:
    """A picture of a floor plan: metres to pixels, x to the right, y up."""

    def __init__(self, scene: Scene) -> None:
        self._room = scene.room
        corners = np.array(scene.room.corners)
        self._low = corners.min(axis=0)
        extent = corners.max(axis=0) - self._low
        self._scale = (SIDE - 2 * MARGIN) / float(extent.max())
        width, height = (round(float(side)) for side in extent * self._scale + 2 * MARGIN)
        self._bottom = height - MARGIN
        self._image = Image.new("RGB", (width, height + LEGEND), PAPER)
        self._draw = ImageDraw.Draw(self._image)
        self._font = ImageFont.load_default(LETTER)

    def raster(self, heat_map: HeatMap) -> None:
        """The map of a floor, or of tops over it."""
        rows, columns = heat_map.values.shape
        x, y = heat_map.origin
        left, top = self._at((x, y + rows * heat_map.cell))
        right, bottom = self._at((x + columns * heat_map.cell, y))
        size = max(1, round(right - left)), max(1, round(bottom - top))
        values = heat_map.values[::-1]  # the picture begins at the top, the map at the smallest y
        mask = Image.fromarray(np.where(values > 0, np.uint8(255), np.uint8(0)))
        colors = Image.fromarray(_colors(values))
        nearest = Image.Resampling.NEAREST
        corner = round(left), round(top)
        self._image.paste(colors.resize(size, nearest), corner, mask.resize(size, nearest))

    def along_walls(self, heat_map: HeatMap) -> None:
        """The best value above every piece of the walls, as a band along them."""
        best = heat_map.values.max(axis=0)
        colors = _colors(best)
        corners = np.array([*self._room.corners, self._room.corners[0]])
        lengths = np.hypot(*np.diff(corners, axis=0).T)
        along = np.concatenate([[0.0], np.cumsum(lengths)])
        edges = heat_map.origin[0] + heat_map.cell * np.arange(len(best) + 1)
        places = np.stack([np.interp(edges, along, corners[:, axis]) for axis in (0, 1)], axis=1)
        for column in np.flatnonzero(best):
            ends = [self._at(tuple(place)) for place in places[column : column + 2]]
            self._draw.line(ends, fill=tuple(colors[column].tolist()), width=BAND)

    def walls(self) -> None:
        """The outline, with gaps for the doors and the windows colored."""
        corners = [self._at(corner) for corner in self._room.corners]
        self._draw.line([*corners, corners[0]], fill=INK, width=OUTLINE, joint="curve")
        for openings, color in ((self._room.doors, PAPER), (self._room.windows, WINDOW)):
            for opening in openings:
                ends = [self._at(opening.start), self._at(opening.end)]
                self._draw.line(ends, fill=color, width=OUTLINE)

    def box(self, center: Vector3, size: Vector3, heading: float, *, text: str, color: str) -> None:
        """The outline of a box, a line to its front, and its name."""
        middle = np.array(center[:2])
        ahead = np.array([np.cos(heading), np.sin(heading)]) * size[0] / 2
        aside = np.array([-np.sin(heading), np.cos(heading)]) * size[1] / 2
        corners = [middle + ahead + aside, middle + ahead - aside]
        corners += [middle - ahead - aside, middle - ahead + aside]
        self._draw.polygon([self._at(tuple(c)) for c in corners], outline=color, width=3)
        self._draw.line([self._at(tuple(middle)), self._at(tuple(middle + ahead))], fill=color)
        self._draw.text(
            self._at(tuple(middle)), text, fill=INK, font=self._font, anchor="mm",
            stroke_width=3, stroke_fill=PAPER,
        )  # fmt: skip

    def legend(self, low: str, high: str) -> None:
        """The colors from least to most likely, between two words."""
        middle = self._image.height - LEGEND // 2
        left = MARGIN + self._draw.textlength(low, font=self._font) + LETTER
        bar = Image.fromarray(_colors(np.arange(1, 256, dtype=np.uint8)[None])).resize(
            (255, LETTER)
        )
        self._draw.text((MARGIN, middle), low, fill=INK, font=self._font, anchor="lm")
        self._image.paste(bar, (round(left), middle - LETTER // 2))
        right = left + bar.width + LETTER
        self._draw.text((right, middle), high, fill=INK, font=self._font, anchor="lm")

    def png(self) -> bytes:
        """The file."""
        file = BytesIO()
        self._image.save(file, "PNG")
        return file.getvalue()

    def _at(self, point: Point) -> tuple[float, float]:
        """Where a point of the room is in the picture."""
        x, y = (np.array(point) - self._low) * self._scale
        return MARGIN + float(x), self._bottom - float(y)


def _colors(values: Bytes) -> Bytes:
    """The colors of values 1 to 255: (…, 3) uint8."""
    steps: Floats = np.array([ImageColor.getrgb(color) for color in CIVIDIS], dtype=float)
    at = np.linspace(1, 255, len(steps))
    channels = [np.interp(values, at, steps[:, channel]) for channel in range(3)]
    return np.stack(channels, axis=-1).astype(np.uint8)
