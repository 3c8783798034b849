"""Control meshes as arrays."""
from __future__ import annotations

import os
from typing import Any, Iterable, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _honeycomb


class Mesh:
    """An oriented manifold of polygons: each face the loop of its vertices, counter-clockwise seen from outside.

    points         (n, 3) positions of the vertices
    face_vertices  face after face the numbers of its vertices, from 0; of two dimensions where all faces have as many
                   sides: a row a face
    face_sizes     how many sides each face has, from 3
    face_offsets   or where each face begins in face_vertices, and its end: one more than there are faces
    creases        (vertex, vertex, sharpness) of edges that stay sharp for that many levels, from 10 on for all
    corners        boundary vertices that the brick boundary keeps in place

    Its attributes are arrays: points of float32, face_offsets of int64, face_vertices and corners of int32, creases with
    the fields vertex0, vertex1 and sharpness. Arrays that have these types already are kept as they are; others are
    copied. Whether the polygons are a manifold is found out by Tables. Raises TypeError for what are no numbers,
    ValueError for shapes and numbers that don't fit.
    """

    def __init__(self, points: ArrayLike, face_vertices: ArrayLike, *, face_sizes: Optional[ArrayLike] = None,
                 face_offsets: Optional[ArrayLike] = None,
                 creases: Iterable[Tuple[int, int, float]] = (), corners: ArrayLike = ()) -> None:
        self.points: NDArray[np.float32] = _positions(points)
        vertices = np.asarray(face_vertices)
        self.face_offsets: NDArray[np.int64] = _offsets(vertices, face_sizes, face_offsets)
        self.face_vertices: NDArray[np.int32] = _integers(vertices.reshape(-1), "face_vertices", np.int32)
        self.creases: NDArray[Any] = _creases(creases)
        self.corners: NDArray[np.int32] = _integers(corners, "corners", np.int32)

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> Mesh:
        """Reads OBJ with creases, PLY, and where the library has Assimp the first pose of glTF, FBX, COLLADA ..
        The arrays are the reader's memory, and not to be written. Raises Error."""
        mesh = cls.__new__(cls)
        (mesh.points, mesh.face_offsets, mesh.face_vertices, mesh.creases, mesh.corners) = _honeycomb.read_mesh(path)
        return mesh

    @property
    def face_count(self) -> int:
        return len(self.face_offsets) - 1

    def __repr__(self) -> str:
        return f"<honeycomb.Mesh of {len(self.points)} vertices and {self.face_count} faces>"


def _positions(given: ArrayLike) -> NDArray[np.float32]:
    points = np.asarray(given)
    if points.dtype.kind not in "fiu":
        raise TypeError(f"points are {points.dtype}; give numbers")
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"points have the shape {points.shape}; give (n, 3)")
    return np.ascontiguousarray(points, np.float32)


def _integers(given: ArrayLike, name: str, kind: type) -> NDArray[Any]:
    """Of one dimension; what doesn't fit into the type is refused rather than cut."""
    numbers = np.asarray(given)
    if numbers.size == 0:
        return np.zeros(0, kind)
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name} are {numbers.dtype}; give integers")
    if numbers.ndim != 1:
        raise ValueError(f"{name} have {numbers.ndim} dimensions; give one")
    limits: Any = np.iinfo(kind)
    if numbers.min() < limits.min or numbers.max() > limits.max:
        raise ValueError(f"{name} go from {numbers.min()} to {numbers.max()}; give {limits.bits}-bit numbers")
    return np.ascontiguousarray(numbers, kind)


def _offsets(vertices: NDArray[Any], sizes: Optional[ArrayLike], offsets: Optional[ArrayLike]) -> NDArray[np.int64]:
    if vertices.ndim == 2:
        if sizes is not None or offsets is not None:
            raise ValueError("rows of face_vertices say where faces end; leave out face_sizes and face_offsets")
        return np.arange(len(vertices) + 1, dtype=np.int64) * vertices.shape[1]
    if offsets is not None and sizes is None:
        return _integers(offsets, "face_offsets", np.int64)
    if sizes is None or offsets is not None:
        raise ValueError("give face_sizes or face_offsets, one of them, or face_vertices with a row a face")
    return np.concatenate([[0], np.cumsum(_integers(sizes, "face_sizes", np.int32), dtype=np.int64)])


def _creases(given: Iterable[Tuple[int, int, float]]) -> NDArray[Any]:
    if isinstance(given, np.ndarray) and given.dtype == _honeycomb.crease:
        return np.ascontiguousarray(given)
    return np.array([tuple(crease) for crease in given], _honeycomb.crease)
