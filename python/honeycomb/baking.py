"""What takes several calls: a mesh refined once, an animation to a file."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterable, Optional, Sized, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._honeycomb import Evaluator, Frames, FrameWriter, Tables
from .mesh import Mesh

if TYPE_CHECKING:
    from ._honeycomb import _Backend


def refine(mesh: Mesh, scheme: str = "akleman", levels: int = 0, **options: Any) -> Tuple[NDArray[np.float32], Tables]:
    """Positions of the last level's vertices, and the tables that have its faces: tables.faces(), tables.triangles().
    Arguments: those of Tables but central_points. For many frames keep the tables and an Evaluator. Raises Error."""
    tables = Tables(mesh, scheme, levels, **options)
    points = Evaluator(tables).refine(mesh.points)
    return points[:tables.counts().vertices], tables


def bake(tables: Tables, frames: Iterable[NDArray[np.float32]], path: Union[str, "os.PathLike[str]"], *,
         count: Optional[int] = None, start: Optional[float] = None, rate: Optional[float] = None,
         frames_per_second: Optional[float] = None, backend: _Backend = "auto") -> int:
    """Refines control points frame by frame into a point cache (.pc2, .mdd) of the last level's vertices, which has its
    name only when it is whole. Returns how many frames there were.

    frames             arrays of control points, float32 and (tables.control_points, 3): Frames, a list, a generator ..
    count              how many there are, where len(frames) doesn't say
    start, rate        time of the first frame and between two, in frames; those of Frames, else 0 and 1
    frames_per_second  of these times; that of Frames, else 24

    Raises Error, also where there are fewer frames than the count, or more.
    """
    if count is None:
        if not isinstance(frames, Sized):
            raise TypeError("frames don't say how many they are; give count")
        count = len(frames)
    times = {"start": start, "rate": rate, "frames_per_second": frames_per_second}
    for name in times:
        if times[name] is None and isinstance(frames, Frames):
            times[name] = getattr(frames, name)
    evaluator = Evaluator(tables, backend)
    refined = np.empty((tables.counts().points, 3), np.float32)
    vertices = refined[:tables.counts().vertices]
    given = {name: time for name, time in times.items() if time is not None}
    with FrameWriter(path, len(vertices), count, **given) as writer:
        for control in frames:
            evaluator.refine(control, out=refined)
            writer.write(vertices)
    return count
