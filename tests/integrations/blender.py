"""Tests the Blender add-on without a window: `blender.py FOLDER GAME.glb HEIGHT ADDRESS` prints a line per check.

FOLDER contains the repository, GAME.glb is a game tree of HEIGHT metres, and ADDRESS is that of a running service.
"""

import json
import math
import os
import sys
import tempfile
import zipfile

import bpy

repository, game, height, address = sys.argv[1:]
sys.path.insert(0, os.path.join(repository, "integrations", "blender"))
import panicle  # noqa: E402
from panicle import importing, levels, source, wind  # noqa: E402


def check(title, passed, found=""):
    print("CHECK " + json.dumps({"title": title, "passed": bool(passed), "found": str(found)}))


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def meshes_of(collection):
    return [thing for thing in collection.all_objects if thing.type == "MESH"]


def tops(things):
    """Returns the greatest height of objects, with modifiers, at the current frame."""
    graph = bpy.context.evaluated_depsgraph_get()
    points = []
    for thing in things:
        mesh = thing.evaluated_get(graph).to_mesh()
        points += [thing.matrix_world @ vertex.co for vertex in mesh.vertices]
    return points


fresh()
panicle.register()

# Levels, sizes, materials and wind of a game tree.
plant = importing.import_plant(game, "Tree", bpy.context)
found = levels.levels_of(plant)
check("a game tree has at least three levels", len(found) >= 3, found)
parts = {child.name[len("Tree ") :]: child for child in plant.children}
triangles = []
for level in found:
    count = 0
    for thing in meshes_of(parts[f"LOD{level}"]):
        thing.data.calc_loop_triangles()
        count += len(thing.data.loop_triangles)
    triangles.append(count)
check("each level has fewer triangles than the one before", triangles == sorted(triangles, reverse=True), triangles)
check("only the finest level is visible", [parts[f"LOD{level}"].hide_render for level in found] == [False] + [True] * (len(found) - 1))
check("the collision shape is hidden", "Collision" in parts and parts["Collision"].hide_render, sorted(parts))
first = meshes_of(parts["LOD0"])
for thing in first:
    thing.modifiers["Wind"].show_viewport = False
measured = max(point.z for point in tops(first))
check("its height is in metres", abs(measured - float(height)) < 0.02 * float(height), f"{measured} for {height}")
for thing in first:
    thing.modifiers["Wind"].show_viewport = True
materials = {slot.material for thing in first for slot in thing.material_slots}
check("it has at most two materials", 1 <= len(materials) <= 2, [each.name for each in materials])
leaves = [each for each in materials if not each.use_backface_culling]
check("leaves are double-sided", len(leaves) == 1, [each.name for each in leaves])
kinds = [node.type for each in leaves for node in each.node_tree.nodes]
check("light shines through leaves", "BSDF_TRANSLUCENT" in kinds, kinds)
def tinting(material, data):
    """Returns the links by which vertex colours with wind data colour a material."""
    return [
        link
        for link in material.node_tree.links
        if link.from_node.type == "VERTEX_COLOR" and link.from_node.layer_name == data and link.from_socket.name == "Color"
    ]


data = wind.data_of(first[0].data)
check("wind data does not tint the plant", not [link for each in materials for link in tinting(each, data)], data)

scene = bpy.context.scene


def at(frame):
    scene.frame_set(frame)
    return tops(first)


def moved(one, other):
    return [(a - b).length for a, b in zip(one, other)]


calm, blown, later = at(1), at(40), at(1 + 10 * scene.render.fps)
distances = moved(calm, blown)
check("the wind moves it", 0.005 < max(distances) < 0.2 * float(height), max(distances))
# Low branches may hang beside the foot of the trunk.
near = 0.04 * float(height)
foot = max(d for d, point in zip(distances, calm) if point.z < 0.5 * near and math.hypot(point.x, point.y) < near)
check("its foot does not move", foot < 0.002 * float(height), foot)
check("the motion repeats after 10 seconds", max(moved(calm, later)) < 1e-3, max(moved(calm, later)))
bpy.ops.panicle.level(plant="Tree", level=found[-1])
check("another level can be shown", [parts[f"LOD{level}"].hide_render for level in found] == [True] * (len(found) - 1) + [False])

# Archives.
folder = tempfile.mkdtemp()
archive, broken = os.path.join(folder, "tree.zip"), os.path.join(folder, "broken.zip")
with zipfile.ZipFile(archive, "w") as file:
    file.write(game, "Tree.glb")
packed = importing.import_plant(archive, "Packed", bpy.context)
check("an archive is imported like its GLB", levels.levels_of(packed) == found, levels.levels_of(packed))
with open(broken, "wb") as file:
    file.write(b"none")

# The panel with a service.
settings = scene.panicle
settings.address = address
bpy.ops.panicle.load()
check("the service lists trees", settings.model == "growth", settings.model)
settings.preset, settings.seed, settings.form = "oak", 3, "glb"
chosen = next(each for each in settings.parameters if each.key == "age")
chosen.changed, chosen.number = True, 4
before = len(bpy.data.objects)
check("the panel grows a plant with the chosen parameters", bpy.ops.panicle.grow() == {"FINISHED"} and len(bpy.data.objects) > before)
grown = bpy.data.collections.get("oak 3")
young = max(point.z for point in tops(meshes_of(grown))) if grown else 0
check("the parameter changes the plant", 0 < young < 0.7 * float(height), young)
check("a plant without levels has no wind", grown and not any(thing.modifiers for thing in meshes_of(grown)))


def message(call):
    """Returns the message of the error that a call ends with."""
    try:
        call()
    except (RuntimeError, source.SourceError, FileNotFoundError) as error:
        return str(error)
    return ""


settings.address = "http://127.0.0.1:9"
check("a missing service is reported with a remedy", "npm run service" in message(lambda: bpy.ops.panicle.load()))
settings.address = "not an address"
check("a wrong address is reported", "is not the address of a service" in message(lambda: bpy.ops.panicle.load()))
refused = message(lambda: source.Service(address).write("/dev/null", "growth", "no-such-tree", 1, {}, "glb"))
check("the message of the service is shown", "no preset" in refused, refused)
check("a wrong folder is reported", "is not a copy of Panicle" in message(lambda: source.CommandLine("/nowhere").catalogue()))
listed = source.CommandLine(repository).catalogue()
check("the command line lists the same plants", listed == source.Service(address).catalogue(), len(listed))
missing = message(lambda: bpy.ops.panicle.import_file(filepath="/nowhere/tree.glb"))
check("a missing file is reported", "does not exist" in missing, missing)
damaged = message(lambda: bpy.ops.panicle.import_file(filepath=broken))
check("a damaged archive is reported", "is not a ZIP file" in damaged, damaged)
panicle.unregister()
check("the add-on can be removed", not hasattr(bpy.types.Scene, "panicle"))
