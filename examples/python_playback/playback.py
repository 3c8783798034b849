#!/usr/bin/env python3
"""Plays back a deforming mesh: tables once, then every frame of a point cache; a picture of some frames, if matplotlib is
there, else a mesh of the last one.
    playback.py MESH.obj FRAMES.pc2 [levels]"""
import sys
import time

import honeycomb
import numpy as np

LIGHT = np.array([-0.4, -0.5, 0.8]) / np.linalg.norm([-0.4, -0.5, 0.8])


class Playback:
    """A mesh's tables, and the arrays that all frames share."""

    def __init__(self, mesh, levels):
        # Once per mesh: its levels, and the tiles that the evaluator goes by.
        self.tables = honeycomb.Tables(mesh, "akleman", levels, normals="fast", tiles=True)
        self.evaluator = honeycomb.Evaluator(self.tables)
        count = self.tables.counts().points
        self.positions = np.empty((count, 3), np.float32)
        self.normals = np.empty((count, 3), np.float32)

    def show(self, control):
        """Every frame: positions and normals of the finest level, in the same arrays."""
        self.evaluator.refine(control, out=self.positions, normals=self.normals)


def draw(axes, playback):
    """The faces of the frame that is shown, each in one shade."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # only here is it needed
    offsets, vertices = playback.tables.faces()
    # OBJ files have y upwards, matplotlib z.
    positions, normals = (array[:, [0, 2, 1]] * [1, -1, 1] for array in (playback.positions, playback.normals))
    polygons = [positions[face] for face in np.split(vertices, offsets[1:-1])]
    sums = np.add.reduceat(normals[vertices], offsets[:-1])
    shades = 0.35 + 0.65 * np.clip(sums @ LIGHT / np.linalg.norm(sums, axis=1).clip(1e-9), 0, 1)
    axes.add_collection3d(Poly3DCollection(polygons, facecolors=shades[:, None] * [1.0, 0.78, 0.42], edgecolors="none"))
    low, high = positions.min(axis=0), positions.max(axis=0)
    for set_limits, least, most in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), low, high):
        set_limits(least, most)
    axes.set_box_aspect(high - low, zoom=1.9)
    axes.set_axis_off()
    axes.view_init(elev=15, azim=-60)


def picture(playback, frames, path):
    import matplotlib
    matplotlib.use("Agg")  # a file, no window
    from matplotlib import pyplot
    figure = pyplot.figure(figsize=(12, 3.2))
    for place, number in enumerate(np.linspace(0, len(frames) - 1, 4).astype(int)[:3], 1):
        playback.show(frames[number])
        axes = figure.add_subplot(1, 3, place, projection="3d")
        axes.set_title(f"frame {number}")
        draw(axes, playback)
    figure.savefig(path, dpi=100)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    mesh, frames = honeycomb.Mesh.read(sys.argv[1]), honeycomb.Frames(sys.argv[2])
    playback = Playback(mesh, int(sys.argv[3]) if len(sys.argv) > 3 else 2)
    finest = playback.tables.counts()
    print(f"{mesh.face_count} faces become {finest.faces}, {finest.vertices} vertices")

    lowest, highest, start = np.inf, -np.inf, time.perf_counter()
    for control in frames:
        playback.show(control)
        lowest, highest = min(lowest, playback.positions.min()), max(highest, playback.positions.max())
    took = time.perf_counter() - start
    print(f"{len(frames)} frames, {1000 * took / len(frames):.2f} ms each, coordinates from {lowest:.4f} to {highest:.4f}")

    try:
        picture(playback, frames, "playback.png")
        print("playback.png shows three of them")
    except ImportError:
        honeycomb.write_mesh("playback.obj", playback.tables, playback.positions, playback.normals)
        print("playback.obj is the last of them (python3-matplotlib would draw them)")


if __name__ == "__main__":
    main()
