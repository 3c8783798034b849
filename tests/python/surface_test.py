"""Refined points against the honeycomb program's, bit for bit, and against the golden files."""
import pathlib
import tempfile
import unittest

import honeycomb
import numpy as np
from shapes import CREATURE, CUBE_POINTS, ROOT, bits, cube, run_program

BACKENDS = ["auto", "serial", "simd", "tbb", "simd-tiled", "tbb-tiled"]


class SameAsTheProgram(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.fine = pathlib.Path(self.folder.name) / "fine.obj"

    def test_points_and_faces_of_schemes_chains_and_options(self):
        for scheme, levels, words, options in [
                ("akleman", 2, [], {}), ("zhang-wang", 1, [], {}), ("half-box", 2, [], {}),
                ("catmull-clark:1,akleman:1", 0, [], {}),
                ("akleman", 1, ["--tension", "sqrt3", "--boundary", "eq16", "--sn", "0.125"],
                 {"tension": "sqrt3", "boundary": "eq16", "sn": 0.125}),
                ("half-box", 1, ["--tuned", "first"], {"tuned": "first", "convert": None})]:
            with self.subTest(scheme, **options):
                run_program("refine", CREATURE, self.fine, "--scheme", scheme, *(["--levels", levels] if levels else []),
                            *words)
                theirs = honeycomb.Mesh.read(self.fine)
                points, tables = honeycomb.refine(honeycomb.Mesh.read(CREATURE), scheme, levels, **options)
                offsets, vertices = tables.faces()
                np.testing.assert_array_equal(bits(points), bits(theirs.points))
                np.testing.assert_array_equal(offsets, theirs.face_offsets)
                np.testing.assert_array_equal(vertices, theirs.face_vertices)

    def test_written_meshes_are_the_programs(self):
        own = pathlib.Path(self.folder.name) / "own.obj"
        run_program("refine", CREATURE, self.fine, "--levels", 2, "--normals", "exact")
        mesh = honeycomb.Mesh.read(CREATURE)
        tables = honeycomb.Tables(mesh, "akleman", 2, normals="exact")
        normals = np.empty((tables.counts().vertices, 3), np.float32)
        points = honeycomb.Evaluator(tables).refine(mesh.points, normals=normals)
        honeycomb.write_mesh(own, tables, points, normals)
        self.assertEqual(self.fine.read_bytes(), own.read_bytes())


class Golden(unittest.TestCase):
    def test_points_of_level_two(self):
        for name, scheme in [("akleman", "akleman"), ("centroid", "centroid"), ("doo-sabin", "doo-sabin")]:
            golden = honeycomb.Mesh.read(ROOT / f"tests/golden/{name}/cube_L2.obj").points
            points, _ = honeycomb.refine(honeycomb.Mesh.read(ROOT / "tests/golden/cube.obj"), scheme)
            np.testing.assert_allclose(ordered(points), ordered(golden), atol=2e-6)


def ordered(points):
    """Golden files number vertices in their own order."""
    return points[np.lexsort(np.round(points.astype(np.float64), 4).T)]


def farthest(points, surface):
    """How far the farthest is from the surface's nearest point."""
    return np.sqrt(((points[:, None, :] - surface[None, :, :]) ** 2).sum(axis=2)).min(axis=1).max()


class Evaluation(unittest.TestCase):
    def test_backends_give_the_same_bits(self):
        mesh = honeycomb.Mesh.read(CREATURE)
        for kind in ("fast", "exact"):
            tables = honeycomb.Tables(mesh, "akleman", 2, normals=kind, tiles=True)
            results = []
            for backend in BACKENDS:
                normals = np.empty((tables.counts().points, 3), np.float32)
                points = honeycomb.Evaluator(tables, backend).refine(mesh.points, normals=normals)
                results.append(np.hstack([bits(points), bits(normals)]))
            for backend, result in zip(BACKENDS, results):
                np.testing.assert_array_equal(results[0], result, backend)
            np.testing.assert_allclose(np.linalg.norm(results[0].view(np.float32)[:, 3:], axis=1), 1, atol=1e-6)

    def test_levels_in_between_have_counts_and_points(self):
        tables = honeycomb.Tables(cube(), levels=3)
        evaluator = honeycomb.Evaluator(tables)
        self.assertEqual([(8, 6), (24, 14), (72, 38), (216, 110)],
                         [(tables.counts(level).vertices, tables.counts(level).faces) for level in range(4)])
        for level in (1, 2, 3):
            np.testing.assert_array_equal(evaluator.refine(CUBE_POINTS, level=level),
                                          honeycomb.refine(cube(), levels=level)[0])
        with self.assertRaisesRegex(honeycomb.Error, "level 4 is out of range"):
            evaluator.refine(CUBE_POINTS, level=4)

    def test_points_of_any_length(self):
        evaluator = honeycomb.Evaluator(honeycomb.Tables(cube()))
        wide = np.hstack([CUBE_POINTS, CUBE_POINTS * 2, CUBE_POINTS[:, :1]]).astype(np.float32)
        refined = evaluator.refine(wide)
        np.testing.assert_array_equal(refined[:, :3], evaluator.refine(CUBE_POINTS))
        np.testing.assert_array_equal(refined[:, 3:6], refined[:, :3] * 2)

    def test_limits_lie_where_more_levels_lead(self):
        tables = honeycomb.Tables(cube(), levels=1, limits=True)
        evaluator = honeycomb.Evaluator(tables)
        points = evaluator.refine(CUBE_POINTS)
        normals = np.empty((24, 3), np.float32)
        limits = evaluator.limits(points, normals=normals)
        surface, _ = honeycomb.refine(cube(), levels=7)
        self.assertLess(farthest(limits, surface), 0.02)
        self.assertGreater(farthest(points, surface), 0.1)
        self.assertTrue((((limits - 0.5) * normals).sum(axis=1) > 0.3).all(), "normals lead outwards")
        faces = evaluator.limits(points, kind="face")
        self.assertEqual((14, 3), faces.shape)
        np.testing.assert_allclose(faces.mean(axis=0), 0.5, atol=1e-6)

    def test_central_points_follow_vertices(self):
        tables = honeycomb.Tables(cube(), "zhang-wang", 1, central_points=True)
        self.assertEqual(14, tables.control_points)
        centres = CUBE_POINTS[np.asarray(cube().face_vertices).reshape(6, 4)].mean(axis=1)
        points = honeycomb.Evaluator(tables).refine(np.vstack([CUBE_POINTS, centres]).astype(np.float32))
        np.testing.assert_allclose(points[:24], honeycomb.refine(cube(), "zhang-wang", 1)[0][:24], atol=1e-6)

    def test_what_tables_lack_is_said_in_pythons_words(self):
        evaluator = honeycomb.Evaluator(honeycomb.Tables(cube()))
        points = evaluator.refine(CUBE_POINTS)
        with self.assertRaisesRegex(honeycomb.Error, "Tables' normals, or give None"):
            evaluator.refine(CUBE_POINTS, normals=np.empty_like(points))
        with self.assertRaisesRegex(honeycomb.Error, "Tables' limits"):
            evaluator.limits(points)
        with self.assertRaisesRegex(honeycomb.Error, "Tables' tiles"):
            honeycomb.Evaluator(evaluator.tables, "tbb-tiled").refine(CUBE_POINTS)


class Choices(unittest.TestCase):
    def test_wrong_ones_are_listed(self):
        for message, make in [("choose from: none, fast, exact", lambda: honeycomb.Tables(cube(), normals="all")),
                              ("choose from: input, spatial", lambda: honeycomb.Tables(cube(), order="random")),
                              ("choose from: auto, serial",
                               lambda: honeycomb.Evaluator(honeycomb.Tables(cube()), "cuda"))]:
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                make()
        for message, code, make in [
                ("choose from: akleman", "INVALID_ARGUMENT", lambda: honeycomb.Tables(cube(), "loup")),
                ("no scheme has such an option", "INVALID_ARGUMENT", lambda: honeycomb.Tables(cube(), colour=1)),
                ("use fewer levels", "TOO_LARGE", lambda: honeycomb.Tables(cube(), levels=5, memory_limit=1000))]:
            with self.subTest(message), self.assertRaisesRegex(honeycomb.Error, message) as caught:
                make()
            self.assertEqual(code, caught.exception.code)


class TableFiles(unittest.TestCase):
    def test_opened_ones_give_the_same_bits(self):
        mesh = honeycomb.Mesh.read(CREATURE)
        built = honeycomb.Tables(mesh, "half-box", 1, normals="fast", tiles=True)
        with tempfile.TemporaryDirectory() as folder:
            built.save(f"{folder}/creature.hct")
            opened = honeycomb.Tables.open(f"{folder}/creature.hct")
        for tables in (built, opened):
            self.assertEqual((2, "fast", True), (tables.levels, tables.normals, tables.tiles))
        np.testing.assert_array_equal(bits(honeycomb.Evaluator(built).refine(mesh.points)),
                                      bits(honeycomb.Evaluator(opened).refine(mesh.points)))
        for mine, theirs in zip(built.faces(), opened.faces()):
            np.testing.assert_array_equal(mine, theirs)
        with self.assertRaisesRegex(honeycomb.Error, "in a file already"):
            opened.save("elsewhere.hct")

    def test_what_is_none_is_refused(self):
        with self.assertRaises(honeycomb.Error) as caught:
            honeycomb.Tables.open(CREATURE)
        self.assertEqual("INVALID_FILE", caught.exception.code)


class IndexBuffers(unittest.TestCase):
    def test_triangles_and_lines_are_the_faces(self):
        tables = honeycomb.Tables(honeycomb.Mesh.read(CREATURE), levels=1)
        offsets, vertices = tables.faces()
        fans, edges = [], set()
        for begin, end in zip(offsets[:-1], offsets[1:]):
            face = vertices[begin:end].tolist()
            fans += [[face[0], a, b] for a, b in zip(face[1:-1], face[2:])]
            edges |= {frozenset(edge) for edge in zip(face, face[1:] + face[:1])}
        np.testing.assert_array_equal(tables.triangles(), fans)
        lines = tables.lines()
        self.assertEqual(edges, {frozenset(line) for line in lines.tolist()})
        self.assertEqual(len(edges), len(lines))
        self.assertEqual(len(edges), tables.counts().edges)

    def test_origins_are_control_faces_and_vertices(self):
        origins = honeycomb.Tables(cube(), levels=1).face_origins()
        self.assertEqual([("face", f) for f in range(6)] + [("vertex", v) for v in range(8)],
                         sorted(({1: "vertex", 2: "face"}[kind], number)
                                for number, _, kind in origins.tolist()))
        self.assertEqual({0, 1}, set(origins["level"].tolist()))


if __name__ == "__main__":
    unittest.main()
