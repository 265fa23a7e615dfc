"""A picture of a GLB by Blender as it comes: Cycles, a grey world, one lamp. Arguments: the GLB, the PNG, width, height."""

import math
import sys

import bpy
from mathutils import Vector

SAMPLES = 48
FIELD = math.radians(28)

glb, png, width, height = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=glb)
scene = bpy.context.scene
corners = [
    thing.matrix_world @ Vector(corner) for thing in scene.objects if thing.type == "MESH" for corner in thing.bound_box
]
low = Vector(min(corner[k] for corner in corners) for k in range(3))
high = Vector(max(corner[k] for corner in corners) for k in range(3))
middle, size = (low + high) / 2, high - low


def added(kind, data, place):
    thing = bpy.data.objects.new(kind, data)
    thing.location = place
    thing.rotation_euler = (middle - thing.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(thing)
    return thing


# glTF's front is +Z, which the importer turns to -Y.
across = max(size.z, size.x * height / width)
camera = bpy.data.cameras.new("Camera")
camera.sensor_fit, camera.angle = "VERTICAL", FIELD
camera.clip_start = 0.001
away = size.y / 2 + 0.54 * across / math.tan(FIELD / 2)
scene.camera = added("Camera", camera, middle + Vector((0, -away, 0)))

lamp = bpy.data.lights.new("Lamp", "AREA")
lamp.size = 1.5 * size.z
lamp.energy = 40 * size.z**2
added("Lamp", lamp, middle + 2 * size.z * Vector((-0.6, -1, 0.8)))

world = bpy.data.worlds.new("World")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.9, 0.9, 0.9, 1)
scene.world = world

scene.render.engine = "CYCLES"
scene.cycles.samples = SAMPLES
scene.cycles.use_denoising = True
scene.render.film_transparent = True
scene.render.resolution_x, scene.render.resolution_y = width, height
scene.render.filepath = png
bpy.ops.render.render(write_still=True)
