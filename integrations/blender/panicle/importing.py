"""Imports a plant from a GLB, or from the archive of a game tree: its levels, materials and wind."""

import os
import tempfile
import zipfile

import bpy

from . import levels, materials, wind


def import_plant(path, name, context, with_wind=True):
    """Imports a GLB or an archive with a GLB, sets it up, and returns the collection of the plant at the 3D cursor.

    Raises RuntimeError if the file has no plant.
    """
    if not os.path.isfile(path):
        raise FileNotFoundError(path)
    if not path.lower().endswith(".zip"):
        return _import_glb(path, name, context, with_wind)
    with tempfile.TemporaryDirectory() as folder:
        try:
            with zipfile.ZipFile(path) as archive:
                inside = next((each for each in archive.namelist() if each.lower().endswith(".glb")), None)
                if not inside:
                    raise RuntimeError(f"“{os.path.basename(path)}” contains no GLB file.")
                glb = archive.extract(inside, folder)
        except zipfile.BadZipFile as error:
            raise RuntimeError(f"“{os.path.basename(path)}” is not a ZIP file.") from error
        return _import_glb(glb, name, context, with_wind)


def _import_glb(path, name, context, with_wind):
    """Imports a GLB and sets it up."""
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path)
    objects = [thing for thing in bpy.data.objects if thing not in before]
    plant = levels.arrange(objects, name, context.scene.collection)
    meshes = [thing for thing in objects if thing.type == "MESH" and not levels.is_collision(thing)]
    # Only files with levels have wind data: elsewhere vertex colours are colours.
    moving = [thing for thing in meshes if levels.level_of(thing) is not None and wind.data_of(thing.data)]
    tinted = [thing for thing in moving if wind.data_of(thing.data) == wind.FIRST_COLOURS]
    wind_materials = {slot.material for thing in tinted for slot in thing.material_slots if slot.material}
    for material in {slot.material for thing in meshes for slot in thing.material_slots if slot.material}:
        materials.set_up(material, material in wind_materials)
    if with_wind and moving:
        height = max(max(corner[2] for corner in thing.bound_box) for thing in moving)
        for thing in moving:
            wind.add(thing, height)
    cursor = context.scene.cursor.location
    for thing in objects:
        if not thing.parent:
            thing.location += cursor
    return plant
