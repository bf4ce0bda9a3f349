"""A model as text of Universal Scene Description (USD), with its preview surfaces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from server.furniture.materials import Color
from server.furniture.mesh import Floats, Ints

STAGE = """\
#usda 1.0
(
    customLayerData = {{ string creator = "SceneGen" }}
    defaultPrim = "Model"
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "Model" (kind = "component")
{{
    def Scope "Materials"
    {{
{materials}    }}
{meshes}}}
"""
MESH = """\
    def Mesh "part_{number}" (prepend apiSchemas = ["MaterialBindingAPI"])
    {{
        rel material:binding = </Model/Materials/surface_{surface}>
        uniform token subdivisionScheme = "none"
        uniform bool doubleSided = {thin}
        float3[] extent = [{extent}]
        point3f[] points = [{points}]
        normal3f[] normals = [{normals}] (interpolation = "vertex")
        int[] faceVertexCounts = [{counts}]
        int[] faceVertexIndices = [{faces}]
{uv}    }}
"""
UV = """\
        texCoord2f[] primvars:st = [{uv}] (interpolation = "vertex")
"""
SURFACE = """\
        def Material "surface_{number}"
        {{
            token outputs:surface.connect = <{path}/preview.outputs:surface>
            def Shader "preview"
            {{
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor{color}
                color3f inputs:emissiveColor = {glow}
                float inputs:metallic = {metallic:.4f}
                float inputs:roughness = {roughness:.4f}
                float inputs:opacity = {opacity:.4f}
                token outputs:surface
            }}
{texture}        }}
"""
TEXTURE = """\
            def Shader "coordinates"
            {{
                uniform token info:id = "UsdPrimvarReader_float2"
                string inputs:varname = "st"
                float2 outputs:result
            }}
            def Shader "picture"
            {{
                uniform token info:id = "UsdUVTexture"
                asset inputs:file = @{file}@
                float4 inputs:scale = ({red:.4f}, {green:.4f}, {blue:.4f}, 1)
                float2 inputs:st.connect = <{path}/coordinates.outputs:result>
                token inputs:wrapS = "repeat"
                token inputs:wrapT = "repeat"
                float3 outputs:rgb
            }}
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surface:
    """What a part looks like; colors are linear RGB."""

    color: Color
    """Multiplied with the texture where there is one."""
    opacity: float = 1.0
    metallic: float = 0.0
    roughness: float = 0.8
    glow: Color = (0.0, 0.0, 0.0)
    thin: bool = False
    """Seen from both sides."""
    texture: str | None = None
    """A picture's file beside the text, in sRGB."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Part:
    """Triangles of one surface."""

    positions: Floats
    """(vertices, 3), metres, y up."""
    normals: Floats
    """(vertices, 3), of unit length."""
    faces: Ints
    """(triangles, 3), anticlockwise seen from outside."""
    uv: Floats | None
    """(vertices, 2), from the lower left of the texture."""
    surface: Surface


def stage(parts: Sequence[Part]) -> str:
    """The whole text; surfaces that look alike are written once."""
    numbers: dict[Surface, int] = {}
    for part in parts:
        numbers.setdefault(part.surface, len(numbers))
    return STAGE.format(
        materials="".join(_material(number, surface) for surface, number in numbers.items()),
        meshes="".join(
            _mesh(number, numbers[part.surface], part) for number, part in enumerate(parts)
        ),
    )


def _mesh(number: int, surface: int, part: Part) -> str:
    extent = np.array([part.positions.min(axis=0), part.positions.max(axis=0)])
    return MESH.format(
        number=number,
        surface=surface,
        thin=int(part.surface.thin),
        extent=_tuples(extent, 4),
        points=_tuples(part.positions, 4),  # to 0.1 mm
        normals=_tuples(part.normals, 3),
        counts=", ".join(["3"] * len(part.faces)),
        faces=", ".join(map(str, part.faces.ravel().tolist())),
        uv="" if part.uv is None else UV.format(uv=_tuples(part.uv, 5)),
    )


def _material(number: int, surface: Surface) -> str:
    path = f"/Model/Materials/surface_{number}"
    red, green, blue = surface.color
    color, texture = f" = {_tuple(surface.color)}", ""
    if surface.texture is not None:
        color = f".connect = <{path}/picture.outputs:rgb>"
        texture = TEXTURE.format(path=path, file=surface.texture, red=red, green=green, blue=blue)
    return SURFACE.format(
        number=number,
        path=path,
        color=color,
        glow=_tuple(surface.glow),
        metallic=surface.metallic,
        roughness=surface.roughness,
        opacity=surface.opacity,
        texture=texture,
    )


def _tuple(values: Iterable[float]) -> str:
    return f"({', '.join(f'{value:.4f}' for value in values)})"


def _tuples(rows: NDArray[Any], decimals: int) -> str:
    """Rows (n, k) as a list of tuples, without its brackets."""
    one = "(" + ", ".join([f"%.{decimals}f"] * rows.shape[1]) + ")"
    return ", ".join([one] * len(rows)) % tuple(rows.ravel().tolist())
