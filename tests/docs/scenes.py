"""Small inputs under the names that pages use for the reader's own files."""
import base64
import json
import struct

CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
TRIANGLES = [corner for a, b, c, d in QUADS for corner in (a, b, c, a, c, d)]


def write_soldier(path):
    """A glTF with a box and a clip "walk" of an eighth of a second, in which it takes a step."""
    parts = [struct.pack("<24f", *sum(CORNERS, ())), struct.pack("<36H", *TRIANGLES), struct.pack("<2f", 0, 0.125),
             struct.pack("<6f", 0, 0, 0, 1, 0, 0)]
    views, offset = [], 0
    for part in parts:
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(part)})
        offset += len(part)
    accessors = [
        {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]},
        {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [0.125]},
        {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC3"}]
    data = base64.b64encode(b"".join(parts)).decode()
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "soldier"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "animations": [{"name": "walk", "samplers": [{"input": 2, "output": 3}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
        "buffers": [{"byteLength": offset, "uri": "data:application/octet-stream;base64," + data}],
        "bufferViews": views, "accessors": accessors}))


def write_cloth(folder):
    """cloth_0001.obj and cloth_0002.obj: a box, one of them taller."""
    faces = "".join("f " + " ".join(str(corner + 1) for corner in quad) + "\n" for quad in QUADS)
    for frame in (1, 2):
        points = "".join(f"v {x} {y} {z * frame}\n" for x, y, z in CORNERS)
        (folder / f"cloth_{frame:04}.obj").write_text(points + faces)
