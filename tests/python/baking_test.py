"""Point caches: read, written, baked."""
import pathlib
import tempfile
import unittest

import honeycomb
import numpy as np
from shapes import CREATURE, CREATURE_FRAMES, CUBE_POINTS, cube, run_program


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())


class Bake(Folder):
    def test_gives_the_programs_files(self):
        frames = honeycomb.Frames(CREATURE_FRAMES)
        # Of zhang-wang's points some are no vertices.
        for kind, scheme in [("pc2", "akleman"), ("mdd", "zhang-wang")]:
            own, theirs = self.folder / f"own.{kind}", self.folder / f"theirs.{kind}"
            tables = honeycomb.Tables(honeycomb.Mesh.read(CREATURE), scheme, 1)
            self.assertEqual(72, honeycomb.bake(tables, frames, own))
            run_program("bake", CREATURE, "--cache", CREATURE_FRAMES, theirs, "--scheme", scheme, "--levels", 1)
            self.assertEqual(theirs.read_bytes(), own.read_bytes(), kind)

    def test_takes_any_frames(self):
        tables = honeycomb.Tables(cube())
        poses = [CUBE_POINTS, CUBE_POINTS * 2, CUBE_POINTS + 1]
        honeycomb.bake(tables, poses, self.folder / "list.pc2", start=3, rate=0.5)
        honeycomb.bake(tables, (pose for pose in poses), self.folder / "generator.mdd", count=3, frames_per_second=10)
        listed, generated = (honeycomb.Frames(self.folder / name) for name in ("list.pc2", "generator.mdd"))
        self.assertEqual((3, 72, 3, 0.5), (len(listed), listed.points, listed.start, listed.rate))
        self.assertEqual((0, 1, 10), (generated.start, round(generated.rate, 6), round(generated.frames_per_second, 4)))
        evaluator = honeycomb.Evaluator(tables)
        for pose, one, other in zip(poses, listed, generated):
            np.testing.assert_array_equal(evaluator.refine(pose), one)
            np.testing.assert_array_equal(one, other)

    def test_leaves_nothing_where_it_fails(self):
        tables = honeycomb.Tables(cube())
        path = self.folder / "cube.pc2"

        def broken():
            yield CUBE_POINTS
            raise RuntimeError("no more")

        with self.assertRaisesRegex(RuntimeError, "no more"):
            honeycomb.bake(tables, broken(), path, count=2)
        with self.assertRaisesRegex(honeycomb.Error, "only 1 of 2 frames"):
            honeycomb.bake(tables, iter([CUBE_POINTS]), path, count=2)
        with self.assertRaisesRegex(honeycomb.Error, "has all its 1 frames"):
            honeycomb.bake(tables, [CUBE_POINTS] * 2, path, count=1)
        with self.assertRaisesRegex(TypeError, "give count"):
            honeycomb.bake(tables, iter([CUBE_POINTS]), path)
        with self.assertRaisesRegex(honeycomb.Error, "end in .pc2, .mdd"):
            honeycomb.bake(tables, [CUBE_POINTS], self.folder / "cube.obj")
        self.assertEqual([], self.files())


class Writer(Folder):
    def test_names_the_file_when_it_is_whole(self):
        path = self.folder / "cube.mdd"
        writer = honeycomb.FrameWriter(path, points=8, frames=2)
        writer.write(CUBE_POINTS)
        writer.write(CUBE_POINTS * 2)
        self.assertFalse(path.exists())
        writer.finish()
        self.assertEqual(["cube.mdd"], self.files())
        np.testing.assert_array_equal(CUBE_POINTS * 2, honeycomb.Frames(path)[-1])
        with self.assertRaisesRegex(honeycomb.Error, "make another FrameWriter"):
            writer.write(CUBE_POINTS)
        with honeycomb.FrameWriter(path, points=8, frames=1) as again:
            again.write(CUBE_POINTS)
            again.finish()
        self.assertEqual(1, len(honeycomb.Frames(path)))

    def test_refuses_what_is_no_frame(self):
        with self.assertRaisesRegex(RuntimeError, "stop"), \
                honeycomb.FrameWriter(self.folder / "cube.pc2", points=8, frames=1) as writer:
            for error, message, points in [(TypeError, "float64", CUBE_POINTS.astype(float)),
                                           (ValueError, r"give \(8, 3\)", CUBE_POINTS[:7]),
                                           (ValueError, "not packed", np.zeros((8, 6), np.float32)[:, :3]),
                                           (honeycomb.Error, "NaN|finite", CUBE_POINTS * np.nan)]:
                with self.subTest(message), self.assertRaisesRegex(error, message):
                    writer.write(points)
            raise RuntimeError("stop")
        self.assertEqual([], self.files())


class Reader(Folder):
    def test_counts_frames_from_both_ends(self):
        frames = honeycomb.Frames(CREATURE_FRAMES)
        self.assertEqual((72, 808), (len(frames), frames.points))
        np.testing.assert_array_equal(frames[71], frames[-1])
        self.assertEqual(72, sum(1 for _ in frames))
        for index in (72, -73):
            with self.assertRaises(IndexError):
                frames[index]  # pylint: disable=pointless-statement

    def test_refuses_what_is_cut(self):
        path = self.folder / "cut.pc2"
        path.write_bytes(CREATURE_FRAMES.read_bytes()[:-1])
        with self.assertRaises(honeycomb.Error) as caught:
            honeycomb.Frames(path)
        self.assertEqual(("INVALID_FILE", 71, "other"),
                         (caught.exception.code, caught.exception.element, caught.exception.element_kind))


if __name__ == "__main__":
    unittest.main()
