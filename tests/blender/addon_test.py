"""blender -b --factory-startup --python-exit-code 1 --python addon_test.py -- SITE ROOT: the add-on in Blender."""
import pathlib
import sys
import tempfile
import unittest

SITE, ROOT = sys.argv[sys.argv.index("--") + 1:][:2]
sys.path[:0] = [SITE, str(pathlib.Path(ROOT) / "blender")]

import bpy  # pylint: disable=wrong-import-position
import honeycomb  # pylint: disable=wrong-import-position
import honeycomb_addon  # pylint: disable=wrong-import-position
import numpy as np  # pylint: disable=wrong-import-position

CREATURE, FRAMES = pathlib.Path(ROOT) / "assets/creature.obj", pathlib.Path(ROOT) / "assets/creature.pc2"
FIRST, LAST = 3, 10


def select(thing):
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = thing
    thing.select_set(True)


def add_object(name, points, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    select(thing)
    return thing


def add_creature():
    """Moved by a point cache, two materials: the head's faces have the second."""
    control = honeycomb.Mesh.read(CREATURE)
    faces = [face.tolist() for face in np.split(control.face_vertices, control.face_offsets[1:-1])]
    creature = add_object("creature", control.points.tolist(), faces)
    for name in ("body", "head"):
        creature.data.materials.append(bpy.data.materials.new(name))
    for polygon in creature.data.polygons:
        polygon.material_index = int(polygon.center.x > 1)
    modifier = creature.modifiers.new("animation", "MESH_CACHE")
    modifier.cache_format, modifier.filepath, modifier.frame_start = "PC2", str(FRAMES), 0
    return creature


def points_now(thing):
    with honeycomb_addon.Pose(bpy.context, thing) as mesh:
        return honeycomb_addon.points_of(mesh)


class Operator(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        honeycomb_addon.register()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.cache = str(pathlib.Path(self.folder.name) / "fine.pc2")
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene
        self.scene.frame_start, self.scene.frame_end = FIRST, LAST

    def refined(self, source, **options):
        self.scene.frame_set(5)
        self.assertEqual({"FINISHED"}, bpy.ops.object.honeycomb(cache=self.cache, **options))
        self.assertEqual(5, self.scene.frame_current, "the frame is as it was")
        made = bpy.context.view_layer.objects.active
        self.assertIsNot(source, made)
        return made

    def test_plays_the_refined_animation(self):
        creature = add_creature()
        for scheme in ("akleman", "zhang-wang"):
            select(creature)
            made = self.refined(creature, scheme=scheme, levels=2)
            tables = honeycomb.Tables(honeycomb.Mesh.read(CREATURE), scheme, 2)
            evaluator, frames = honeycomb.Evaluator(tables), honeycomb.Frames(FRAMES)
            for frame in (FIRST, 6, LAST):
                self.scene.frame_set(frame)
                wanted = evaluator.refine(frames[frame])[:tables.counts().vertices]
                np.testing.assert_array_equal(wanted, points_now(made), f"{scheme}, frame {frame}")
            self.assertEqual(tables.counts().faces, len(made.data.polygons))
            self.assertEqual(tables.counts().edges, len(made.data.edges))
            creature.hide_set(False)

    def test_goes_where_the_control_mesh_goes_and_takes_its_place(self):
        creature = add_creature()
        creature.location = (1, 2, 3)
        made = self.refined(creature, levels=1)
        bpy.context.view_layer.update()
        self.assertEqual((1, 2, 3), tuple(made.matrix_world.translation))
        self.assertTrue(creature.hide_get() and creature.hide_render)

    def test_keeps_materials_where_they_were(self):
        creature = add_creature()
        made = self.refined(creature, levels=1)
        self.assertEqual(["body", "head"], [slot.material.name for slot in made.material_slots])
        for polygon in made.data.polygons:
            if abs(polygon.center.x - 1) > 0.3:
                self.assertEqual(int(polygon.center.x > 1), polygon.material_index)

    def test_says_what_is_wrong_with_a_mesh(self):
        book = add_object("book", [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0)], [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
        objects = len(bpy.data.objects)
        with self.assertRaisesRegex(RuntimeError, "face|edge"):
            bpy.ops.object.honeycomb(cache=self.cache)
        self.assertEqual(objects, len(bpy.data.objects))
        self.assertIs(book, bpy.context.view_layer.objects.active)

    def test_refuses_meshes_that_change_their_vertices(self):
        creature = add_creature()
        build = creature.modifiers.new("build", "BUILD")
        build.frame_start, build.frame_duration = FIRST - 20, 200
        with self.assertRaises(RuntimeError):
            bpy.ops.object.honeycomb(cache=self.cache)
        self.assertFalse(pathlib.Path(self.cache).exists())


if __name__ == "__main__":
    result = unittest.TextTestRunner(stream=sys.stderr, verbosity=2).run(
        unittest.defaultTestLoader.loadTestsFromTestCase(Operator))
    sys.exit(not result.wasSuccessful())
