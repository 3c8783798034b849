"""Honeycomb subdivision of deforming meshes, from arrays of numpy to arrays of numpy.

Once a mesh:    tables = honeycomb.Tables(honeycomb.Mesh.read("creature.obj"), "akleman", 3)
                evaluator = honeycomb.Evaluator(tables)
Every frame:    evaluator.refine(control, out=refined)
docs/python.md is the page about it.
"""
from ._honeycomb import Counts, Evaluator, Frames, FrameWriter, Tables, __version__, write_mesh
from .baking import bake, refine
from .error import Error
from .mesh import Mesh

__all__ = ["Counts", "Error", "Evaluator", "FrameWriter", "Frames", "Mesh", "Tables", "__version__", "bake", "refine",
           "write_mesh"]
