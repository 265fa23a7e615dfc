"""What an independent reader makes of files: a line of JSON each with its triangles, or points, and its bounds in metres, +Y up."""

import json
import sys

import numpy


def by_trimesh(path):
    import trimesh

    scene = trimesh.load_scene(path, process=False)
    whole = scene.to_geometry()
    found = {"count": len(getattr(whole, "faces", whole.vertices)), "bounds": whole.bounds}
    if path.endswith((".stl", ".3mf")):
        whole.merge_vertices()
        found["closed"] = bool(whole.is_watertight and whole.is_winding_consistent and whole.volume > 0)
        found["bounds"] = from_printers(whole.bounds)
    return found


def by_blender(path):
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path)
    elif path.endswith(".usdz"):
        bpy.ops.wm.usd_import(filepath=path)
    else:
        bpy.ops.wm.stl_import(filepath=path)
    count, places = 0, []
    for thing in bpy.context.scene.objects:
        if thing.type != "MESH":
            continue
        thing.data.calc_loop_triangles()
        count += len(thing.data.loop_triangles)
        local = numpy.empty(3 * len(thing.data.vertices), numpy.float32)
        thing.data.vertices.foreach_get("co", local)
        turn = numpy.array(thing.matrix_world)
        places.append(local.reshape(-1, 3) @ turn[:3, :3].T + turn[:3, 3])
    every = numpy.concatenate(places)
    bounds = numpy.array([every.min(0), every.max(0)])
    millimetres = path.endswith(".stl")
    return {"count": count, "bounds": from_printers(bounds if millimetres else 1000 * bounds)}


def by_usd(path):
    from pxr import Usd, UsdGeom, UsdValidation

    stage = Usd.Stage.Open(path)
    meshes = [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"])
    box = cache.ComputeWorldBound(stage.GetDefaultPrim()).ComputeAlignedRange()
    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    return {
        "count": sum(len(mesh.GetFaceVertexCountsAttr().Get()) for mesh in meshes),
        "bounds": numpy.array([box.GetMin(), box.GetMax()]),
        "complaints": [error.GetMessage() for error in context.Validate(stage)],
    }


def from_printers(bounds):
    """Millimetres with +Z up to metres with +Y up."""
    low, high = bounds / 1000
    return numpy.array([[low[0], low[2], -high[1]], [high[0], high[2], -low[1]]])


reader, *paths = sys.argv[1:]
for path in paths:
    found = {"trimesh": by_trimesh, "blender": by_blender, "usd": by_usd}[reader](path)
    print("READ " + json.dumps({**found, "bounds": numpy.asarray(found["bounds"], float).tolist()}))
