"""What the tests of the Python module share."""
import os
import pathlib
import subprocess

import honeycomb
import numpy as np

ROOT = pathlib.Path(os.environ["HONEYCOMB_ROOT"])
PROGRAM = os.environ["HONEYCOMB_PROGRAM"]
CREATURE, CREATURE_FRAMES = ROOT / "assets/creature.obj", ROOT / "assets/creature.pc2"

CUBE_POINTS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], np.float32)
CUBE_FACES = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)], np.int32)


def cube(**options):
    return honeycomb.Mesh(CUBE_POINTS, CUBE_FACES, **options)


def run_program(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True, timeout=300)


def bits(array):
    return np.ascontiguousarray(array).view(np.uint32)
