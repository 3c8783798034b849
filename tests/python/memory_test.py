"""Nothing is copied, nothing dies early, nothing is written where it mustn't be."""
import gc
import tracemalloc
import unittest

import honeycomb
import numpy as np
from shapes import CREATURE, CREATURE_FRAMES, CUBE_POINTS, bits, cube


class Outputs(unittest.TestCase):
    def setUp(self):
        self.tables = honeycomb.Tables(cube(), normals="exact", limits=True)
        self.evaluator = honeycomb.Evaluator(self.tables)
        self.points = self.evaluator.refine(CUBE_POINTS)

    def test_are_the_arrays_that_were_given(self):
        out = np.full((72, 3), np.nan, np.float32)
        self.assertIs(out, self.evaluator.refine(CUBE_POINTS, out=out))
        np.testing.assert_array_equal(self.points, out)
        triangles = np.zeros((len(self.tables.triangles()), 3), np.int32)
        self.assertIs(triangles, self.tables.triangles(out=triangles))
        np.testing.assert_array_equal(self.tables.triangles(), triangles)
        limits = np.full((72, 3), np.nan, np.float32)
        self.assertIs(limits, self.evaluator.limits(self.points, out=limits))
        self.assertTrue(np.isfinite(limits).all())

    def test_may_be_columns_of_one_array_as_inputs_may(self):
        normals = np.empty((72, 3), np.float32)
        self.evaluator.refine(CUBE_POINTS, normals=normals)
        control = np.full((8, 5), np.nan, np.float32)
        control[:, 1:4] = CUBE_POINTS
        both = np.full((72, 8), np.inf, np.float32)
        self.evaluator.refine(control[:, 1:4], out=both[:, :3], normals=both[:, 4:7])
        np.testing.assert_array_equal(bits(both[:, :3]), bits(self.points))
        np.testing.assert_array_equal(bits(both[:, 4:7]), bits(normals))
        self.assertTrue(np.isinf(both[:, [3, 7]]).all(), "what lies between belongs to the caller")

    def test_take_no_memory_beside_them(self):
        mesh = honeycomb.Mesh.read(CREATURE)
        evaluator = honeycomb.Evaluator(honeycomb.Tables(mesh))
        wide = np.zeros((len(mesh.points), 4), np.float32)
        wide[:, :3] = mesh.points
        wide_out = np.empty((evaluator.tables.counts().points, 4), np.float32)
        for control, out in [(wide, wide_out), (wide[:, :3], wide_out[:, :3])]:
            tracemalloc.start()
            evaluator.refine(control, out=out)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(peak, mesh.points.nbytes / 2, "numpy tells tracemalloc of its arrays")

    def test_that_do_not_fit_are_refused(self):
        whole = np.empty((72, 6), np.float32)
        backwards = np.empty((72, 3), np.float32)[::-1]
        read_only = np.empty((72, 3), np.float32)
        read_only.flags.writeable = False
        unaligned = np.empty(72 * 12 + 1, np.uint8)[1:].view(np.float32).reshape(72, 3)
        for error, message, out in [(TypeError, "out is an array of float64", np.empty((72, 3))),
                                    (TypeError, "out is an array of >f4", np.empty((72, 3), ">f4")),
                                    (TypeError, "out is of type list", [0]),
                                    (ValueError, r"out has the shape \(71, 3\); give \(72, 3\)", whole[:71, :3]),
                                    (ValueError, r"out has the shape \(72, 4\); give \(72, 3\)", whole[:, :4]),
                                    (ValueError, r"out has the shape \(216,\)", whole.reshape(-1)[:216]),
                                    (ValueError, "out has the strides", whole[:, ::2]),
                                    (ValueError, "out has the strides", backwards),
                                    (ValueError, "out has the strides", np.empty((3, 72), np.float32).T),
                                    (ValueError, "out is read-only", read_only),
                                    (ValueError, "out is not aligned", unaligned)]:
            with self.subTest(message), self.assertRaisesRegex(error, message):
                self.evaluator.refine(CUBE_POINTS, out=out)
        with self.assertRaisesRegex(TypeError, "out is an array of int64"):
            self.tables.lines(out=np.empty((108, 2), np.int64))
        with self.assertRaisesRegex(ValueError, "out is not packed"):
            self.tables.lines(out=np.empty((2, 108), np.int32).T)

    def test_may_not_overlap_what_is_read(self):
        memory = np.zeros((80, 3), np.float32)
        memory[:8] = CUBE_POINTS
        with self.assertRaisesRegex(honeycomb.Error, "overlap") as caught:
            self.evaluator.refine(memory[:8], out=memory[4:76])
        self.assertEqual("INVALID_ARGUMENT", caught.exception.code)
        np.testing.assert_array_equal(CUBE_POINTS, memory[:8])

    def test_are_left_alone_where_points_are_not_finite(self):
        control, out = CUBE_POINTS.copy(), np.zeros((72, 3), np.float32)
        control[5, 1] = np.nan
        with self.assertRaises(honeycomb.Error) as caught:
            self.evaluator.refine(control, out=out)
        self.assertEqual(("INVALID_POSITIONS", 5, "vertex"),
                         (caught.exception.code, caught.exception.element, caught.exception.element_kind))
        self.assertFalse(out.any())
        honeycomb.Evaluator(self.tables, checked=False).refine(control, out=out)
        self.assertTrue(np.isnan(out).any())


class Views(unittest.TestCase):
    def test_of_faces_share_the_tables_memory_and_keep_it(self):
        tables = honeycomb.Tables(cube(), levels=3)
        offsets, vertices = tables.faces()
        self.assertTrue(np.shares_memory(offsets, tables.faces()[0]))
        self.assertTrue(np.shares_memory(vertices, tables.faces()[1]))
        self.assertEqual((tables.counts().faces + 1, tables.counts().corners), (len(offsets), len(vertices)))
        with self.assertRaises(ValueError):
            vertices[0] = 1
        copies = offsets.copy(), vertices.copy()
        del tables
        gc.collect()
        others = [honeycomb.Tables(cube(), levels=3, scheme=scheme) for scheme in ("half-box", "centroid", "akleman")]
        np.testing.assert_array_equal(copies[0], offsets)
        np.testing.assert_array_equal(copies[1], vertices)
        del others

    def test_of_files_share_their_memory_and_keep_it(self):
        frames = honeycomb.Frames(CREATURE_FRAMES)
        frame = frames[3]
        self.assertTrue(np.shares_memory(frame, frames[3]))
        self.assertFalse(frame.flags.writeable)
        copy = frame.copy()
        del frames
        gc.collect()
        np.testing.assert_array_equal(copy, frame)

    def test_evaluators_keep_their_tables(self):
        evaluator = honeycomb.Evaluator(honeycomb.Tables(cube()))
        gc.collect()
        np.testing.assert_array_equal(honeycomb.refine(cube())[0], evaluator.refine(CUBE_POINTS))
        self.assertEqual(2, evaluator.tables.levels)


if __name__ == "__main__":
    unittest.main()
