"""Meshes: arrays in all forms that say the same, and those that say nothing."""
import tempfile
import unittest

import honeycomb
import numpy as np
from shapes import CREATURE, CUBE_FACES, CUBE_POINTS, ROOT, cube


class Polygons(unittest.TestCase):
    def test_rows_sizes_and_offsets_say_the_same(self):
        rows = cube()
        sizes = honeycomb.Mesh(CUBE_POINTS, CUBE_FACES.reshape(-1), face_sizes=[4] * 6)
        offsets = honeycomb.Mesh(CUBE_POINTS, CUBE_FACES.reshape(-1), face_offsets=np.arange(0, 28, 4))
        for mesh in (sizes, offsets):
            np.testing.assert_array_equal(mesh.face_offsets, rows.face_offsets)
            np.testing.assert_array_equal(mesh.face_vertices, rows.face_vertices)
        self.assertEqual(6, rows.face_count)

    def test_arrays_of_the_right_type_are_kept(self):
        mesh = cube()
        self.assertTrue(np.shares_memory(mesh.points, CUBE_POINTS))
        self.assertTrue(np.shares_memory(mesh.face_vertices, CUBE_FACES))

    def test_what_is_read_is_the_files(self):
        mesh = honeycomb.Mesh.read(CREATURE)
        lines = CREATURE.read_text(encoding="utf-8").splitlines()
        points = [line.split()[1:4] for line in lines if line.startswith("v ")]
        np.testing.assert_array_equal(mesh.points, np.array(points, np.float64).astype(np.float32))
        faces = [[int(corner.split("/")[0]) - 1 for corner in line.split()[1:]] for line in lines if line.startswith("f ")]
        np.testing.assert_array_equal(mesh.face_vertices, sum(faces, []))
        np.testing.assert_array_equal(np.diff(mesh.face_offsets), [len(face) for face in faces])
        with self.assertRaises(ValueError):
            mesh.points[0] = 0  # the reader's memory

    def test_creases_come_from_arrays_as_from_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/cube.obj"
            with open(path, "w", encoding="utf-8") as file:
                file.writelines("v {} {} {}\n".format(*point) for point in CUBE_POINTS.tolist())
                file.writelines("f {} {} {} {}\n".format(*face) for face in (CUBE_FACES + 1).tolist())
                file.write("t crease 2/1/0 0 1 2.5\n")
            read = honeycomb.Mesh.read(path)
        made = cube(creases=[(0, 1, 2.5)])
        np.testing.assert_array_equal(read.creases, made.creases)
        refined, smooth = (honeycomb.refine(mesh)[0] for mesh in (read, cube()))
        np.testing.assert_array_equal(refined, honeycomb.refine(made)[0])
        self.assertFalse(np.array_equal(refined, smooth), "the crease is sharp")

    def test_corners_stay_where_they_are(self):
        grid = honeycomb.Mesh.read(ROOT / "tests/golden/grid.obj")
        points, _ = honeycomb.refine(honeycomb.Mesh(grid.points, grid.face_vertices, face_offsets=grid.face_offsets,
                                                    corners=[0]), levels=1, boundary="brick")
        loose, _ = honeycomb.refine(grid, levels=1, boundary="brick")
        corner = grid.points[0]
        self.assertTrue((points == corner).all(axis=1).any())
        self.assertFalse((loose == corner).all(axis=1).any())

    def test_what_is_no_mesh_is_refused_by_name(self):
        flat = CUBE_FACES.reshape(-1)
        for error, message, arguments, options in [
                (TypeError, "points are <U1", ([["a"]], CUBE_FACES), {}),
                (ValueError, r"points have the shape \(8, 2\)", (CUBE_POINTS[:, :2], CUBE_FACES), {}),
                (TypeError, "face_vertices are float64", (CUBE_POINTS, CUBE_FACES.astype(float)), {}),
                (ValueError, "32-bit", (CUBE_POINTS, CUBE_FACES.astype(np.int64) << 40), {}),
                (ValueError, "face_sizes or face_offsets", (CUBE_POINTS, flat), {}),
                (ValueError, "face_sizes or face_offsets", (CUBE_POINTS, flat), {"face_sizes": [4], "face_offsets": [0]}),
                (ValueError, "leave out face_sizes", (CUBE_POINTS, CUBE_FACES), {"face_sizes": [4] * 6})]:
            with self.subTest(message), self.assertRaisesRegex(error, message):
                honeycomb.Mesh(*arguments, **options)

    def test_polygons_that_are_no_manifold_name_their_face(self):
        with self.assertRaisesRegex(honeycomb.Error, "face 5 names vertex 99") as caught:
            honeycomb.Tables(honeycomb.Mesh(CUBE_POINTS, np.vstack([CUBE_FACES[:5], [[2, 0, 4, 99]]])))
        self.assertEqual(("INVALID_MESH", 5, "face"),
                         (caught.exception.code, caught.exception.element, caught.exception.element_kind))
        with self.assertRaisesRegex(TypeError, "give a honeycomb.Mesh"):
            honeycomb.Tables(CUBE_POINTS)

    def test_files_that_are_not_there_say_so(self):
        with self.assertRaisesRegex(honeycomb.Error, "nowhere.obj.*No such file") as caught:
            honeycomb.Mesh.read("nowhere.obj")
        self.assertEqual(("UNREADABLE", None), (caught.exception.code, caught.exception.element))


if __name__ == "__main__":
    unittest.main()
