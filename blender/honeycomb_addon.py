"""Object > Honeycomb: refines the active mesh with its animation. Needs the Python module honeycomb (docs/python.md) in
Blender's own Python: Debian's Blender runs on the system's."""
import os

import bpy
import honeycomb
import numpy as np

bl_info = {
    "name": "Honeycomb subdivision", "author": "The Honeycomb project", "version": (0, 1, 0), "blender": (3, 4, 0),
    "location": "Object > Honeycomb", "category": "Object",
    "description": "Honeycomb subdivision of a mesh and its animation, kept in a point cache",
}

SCHEMES = ["akleman", "zhang-wang", "half-box", "midpoint", "trisect", "centroid", "doo-sabin"]


def numbers(collection, attribute, kind, columns=1):
    """What foreach_get writes: of all items of a collection."""
    array = np.empty(len(collection) * columns, kind)
    collection.foreach_get(attribute, array)
    return array


class Pose:
    """The mesh of an object as its modifiers, shape keys and bones leave it in the current frame."""

    def __init__(self, context, source):
        self.object = source.evaluated_get(context.evaluated_depsgraph_get())
        self.mesh = self.object.to_mesh()

    def __enter__(self):
        return self.mesh

    def __exit__(self, *_):
        self.object.to_mesh_clear()


def points_of(mesh):
    return numbers(mesh.vertices, "co", np.float32, 3).reshape(-1, 3)


def polygons_of(mesh):
    return honeycomb.Mesh(points_of(mesh), numbers(mesh.loops, "vertex_index", np.int32),
                          face_sizes=numbers(mesh.polygons, "loop_total", np.int32))


def poses(context, source, points):
    """The control points of all frames of the scene. Raises ValueError where their number changes."""
    scene = context.scene
    for frame in range(scene.frame_start, scene.frame_end + 1):
        scene.frame_set(frame)
        with Pose(context, source) as mesh:
            if len(mesh.vertices) != points:
                raise ValueError(f"frame {frame} has {len(mesh.vertices)} vertices and the first has {points}; switch off "
                                 "modifiers whose vertices change from frame to frame")
            yield points_of(mesh)


def materials_of(control, tables, given):
    """The material of each refined face: its control face's; round a control vertex that of one of the faces there."""
    of_vertex = np.zeros(len(control.points), np.int32)
    of_vertex[control.face_vertices] = np.repeat(given, np.diff(control.face_offsets))
    origins = tables.face_origins()
    from_faces = origins["kind"] == 2
    return np.where(from_faces, given[np.where(from_faces, origins["number"], 0)],
                    of_vertex[np.where(from_faces, 0, origins["number"])]).astype(np.int32)


def make_mesh(name, tables, points, materials, smooth):
    """A mesh of the last level's faces."""
    offsets, vertices = tables.faces()
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", points.reshape(-1))
    mesh.loops.add(len(vertices))
    mesh.loops.foreach_set("vertex_index", vertices)
    mesh.polygons.add(len(offsets) - 1)
    mesh.polygons.foreach_set("loop_start", offsets[:-1])
    mesh.polygons.foreach_set("loop_total", np.diff(offsets))
    mesh.polygons.foreach_set("material_index", materials)
    mesh.polygons.foreach_set("use_smooth", np.full(len(offsets) - 1, smooth))
    mesh.update(calc_edges=True)
    return mesh


class OBJECT_OT_honeycomb(bpy.types.Operator):
    """Refine the mesh in all frames of the scene, into a point cache that a new object plays"""

    bl_idname = "object.honeycomb"
    bl_label = "Honeycomb"
    bl_options = {"REGISTER", "UNDO"}

    scheme: bpy.props.EnumProperty(name="Scheme", items=[(name, name, "") for name in SCHEMES])
    levels: bpy.props.IntProperty(name="Levels", default=2, min=1, max=6)
    smooth: bpy.props.BoolProperty(name="Shade smooth", default=True)
    cache: bpy.props.StringProperty(name="Cache", subtype="FILE_PATH",
                                    description="A .pc2 file; empty: beside the .blend file, or in Blender's temporary folder")

    @classmethod
    def poll(cls, context):
        return context.active_object is not None and context.active_object.type == "MESH"

    def invoke(self, context, _event):
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        before = context.scene.frame_current
        try:
            self.refine(context, context.active_object)
        except (honeycomb.Error, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            context.scene.frame_set(before)
        return {"FINISHED"}

    def refine(self, context, source):
        scene = context.scene
        scene.frame_set(scene.frame_start)
        with Pose(context, source) as mesh:
            control, materials = polygons_of(mesh), numbers(mesh.polygons, "material_index", np.int32)
        tables = honeycomb.Tables(control, self.scheme, self.levels, tiles=True)
        path = self.path_of(source)
        honeycomb.bake(tables, poses(context, source, len(control.points)), path,
                       count=scene.frame_end - scene.frame_start + 1, start=scene.frame_start,
                       frames_per_second=scene.render.fps / scene.render.fps_base)
        mesh = make_mesh(f"{source.data.name} honeycomb", tables, honeycomb.Frames(path)[0],
                         materials_of(control, tables, materials), self.smooth)
        for slot in source.material_slots:
            mesh.materials.append(slot.material)
        self.add(context, source, mesh, path)

    def path_of(self, source):
        if self.cache:
            return bpy.path.abspath(self.cache)
        folder = os.path.dirname(bpy.data.filepath) or bpy.app.tempdir
        return os.path.join(folder, bpy.path.clean_name(source.name) + "_honeycomb.pc2")

    def add(self, context, source, mesh, path):
        """The refined object, which goes where the control mesh goes, in its place."""
        refined = bpy.data.objects.new(f"{source.name} honeycomb", mesh)
        source.users_collection[0].objects.link(refined)
        refined.parent = source
        modifier = refined.modifiers.new("Honeycomb", "MESH_CACHE")
        modifier.cache_format = "PC2"
        modifier.filepath = path
        modifier.frame_start = context.scene.frame_start
        source.hide_set(True)
        source.hide_render = True
        context.view_layer.objects.active = refined
        refined.select_set(True)


def draw_entry(self, _context):
    self.layout.operator(OBJECT_OT_honeycomb.bl_idname)


def register():
    bpy.utils.register_class(OBJECT_OT_honeycomb)
    bpy.types.VIEW3D_MT_object.append(draw_entry)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_entry)
    bpy.utils.unregister_class(OBJECT_OT_honeycomb)
