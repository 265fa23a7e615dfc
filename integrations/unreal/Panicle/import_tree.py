"""Imports a game tree from Panicle into Unreal Engine: one static mesh with levels of detail, collision and wind.

Run it in the editor, by the menu Tools, Execute Python Script, or in its Python console:

    import import_tree
    import_tree.run("C:/trees/oak.glb", "/Game/Trees")

The plug-ins Python Editor Script Plugin, Interchange and glTF Importer must be enabled.
"""

import os
import re

import unreal

LEVEL = re.compile(r"_LOD(\d)$")
COLLISION = re.compile(r"^UCX_")
# The least share of the view's height at which each level is drawn, the first one for level 0.
SCREEN_SIZES = (1.0, 0.75, 0.26, 0.085)
WIND_NAME = "Panicle wind"
MATERIAL = "M_PanicleTree"

# The wind as code of a custom node. Data is branch phase, branch weight, leaf phase and occlusion; Place is in the
# coordinates of the tree, all others are in the world; centimetres, +Z up. The result is an offset in the world.
WIND_CODE = """
float3 along = normalize(Direction);
float3 across = float3(-along.y, along.x, 0);
float late = dot(Tree, float3(0.0037, 0.0053, 0));
float h = saturate(Place.z / Height);
float turn = 6.2831853 * Data.r + late;
float trunk = 0.022 * Height * h * h * (0.6 + 0.4 * sin(1.3 * Time + late));
float branch = 0.02 * Height * Data.g * sin(2.1 * Time + turn);
float leaf = 3.0 * step(0.001, Data.b) * Data.g * sin(7.0 * Time + 6.2831853 * Data.b + turn);
return Strength * (trunk * along + branch * (0.7 * along + 0.5 * across + float3(0, 0, 0.4)) + leaf * Normal);
"""


def run(path, folder):
    """Imports the GLB at a path into a folder of the project, and returns the static mesh with all levels."""
    if not os.path.isfile(path):
        raise FileNotFoundError(f"The file {path} does not exist.")
    name = os.path.splitext(os.path.basename(path))[0]
    place = f"{folder}/{name}"
    meshes = _import(path, place)
    levels = levels_of([mesh.get_name() for mesh in meshes])
    if not levels:
        raise ValueError(f"{path} is not a game tree: it has no mesh whose name ends with _LOD0.")
    by_name = {mesh.get_name(): mesh for mesh in meshes}
    tree = by_name[levels[0]]
    _join_levels(tree, [by_name[level] for level in levels[1:]])
    _add_collision(tree, [mesh for mesh in meshes if COLLISION.match(mesh.get_name())])
    height = tree.get_bounding_box().max.z
    _use_materials(tree, place, height)
    unreal.EditorAssetLibrary.save_directory(place)
    return tree


def levels_of(names):
    """Returns the names of levels, the finest first."""
    found = {int(match.group(1)): name for name in names if (match := LEVEL.search(name))}
    return [found[number] for number in sorted(found)]


def screen_sizes(count):
    """Returns the screen sizes of so many levels."""
    return [SCREEN_SIZES[min(level, len(SCREEN_SIZES) - 1)] / 2 ** max(0, level - 3) for level in range(count)]


def _import(path, place):
    """Imports all meshes of a GLB as assets."""
    task = unreal.AssetImportTask()
    task.set_editor_property("filename", path)
    task.set_editor_property("destination_path", place)
    task.set_editor_property("automated", True)
    task.set_editor_property("replace_existing", True)
    task.set_editor_property("save", False)
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    assets = [unreal.load_asset(each) for each in unreal.EditorAssetLibrary.list_assets(place, recursive=True)]
    return [asset for asset in assets if isinstance(asset, unreal.StaticMesh)]


def _join_levels(tree, others):
    """Copies the meshes of the other levels into the tree, and removes their assets."""
    editor = unreal.get_editor_subsystem(unreal.StaticMeshEditorSubsystem)
    for level, mesh in enumerate(others, 1):
        editor.set_lod_from_static_mesh(tree, level, mesh, 0, True)
    editor.set_lod_screen_sizes(tree, screen_sizes(1 + len(others)))
    for mesh in others:
        unreal.EditorAssetLibrary.delete_loaded_asset(mesh)


def _add_collision(tree, shapes):
    """Gives the tree convex collision like the shapes UCX_…, and removes their assets."""
    if not shapes:
        return
    editor = unreal.get_editor_subsystem(unreal.StaticMeshEditorSubsystem)
    editor.remove_collisions(tree)
    for shape in shapes:
        # A convex mesh is its own hull: one hull with all of its corners.
        editor.set_convex_decomposition_collisions(shape, 1, 32, 100000)
    body = tree.get_editor_property("body_setup")
    geometry = body.get_editor_property("agg_geom")
    hulls = []
    for shape in shapes:
        own = shape.get_editor_property("body_setup").get_editor_property("agg_geom")
        hulls.extend(own.get_editor_property("convex_elems"))
    geometry.set_editor_property("convex_elems", hulls)
    body.set_editor_property("agg_geom", geometry)
    for shape in shapes:
        unreal.EditorAssetLibrary.delete_loaded_asset(shape)


def _use_materials(tree, place, height):
    """Replaces each imported material by an instance of the material with wind, with the same pictures."""
    for index, slot in enumerate(tree.get_editor_property("static_materials")):
        old = slot.get_editor_property("material_interface")
        is_leaf = _is_two_sided(old)
        parent = _material(place.rsplit("/", 1)[0], is_leaf)
        factory = unreal.MaterialInstanceConstantFactoryNew()
        tools = unreal.AssetToolsHelpers.get_asset_tools()
        name = f"MI_{old.get_name()}"
        made = tools.create_asset(name, place, unreal.MaterialInstanceConstant, factory)
        library = unreal.MaterialEditingLibrary
        library.set_material_instance_parent(made, parent)
        library.set_material_instance_scalar_parameter_value(made, "Height", height)
        for source, target in (("BaseColorTexture", "Colour"), ("NormalTexture", "Normals")):
            picture = library.get_material_instance_texture_parameter_value(old, source)
            if picture:
                library.set_material_instance_texture_parameter_value(made, target, picture)
        tree.set_material(index, made)


def _is_two_sided(material):
    """Whether a material is that of leaves."""
    return bool(material.get_base_material().get_editor_property("two_sided"))


def _material(folder, is_leaf):
    """Returns the material of bark or leaves with wind, which is made once per folder."""
    name = MATERIAL + ("Leaves" if is_leaf else "Bark")
    path = f"{folder}/{name}"
    if unreal.EditorAssetLibrary.does_asset_exist(path):
        return unreal.load_asset(path)
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    material = tools.create_asset(name, folder, unreal.Material, unreal.MaterialFactoryNew())
    library = unreal.MaterialEditingLibrary
    colour = _texture(material, "Colour", unreal.MaterialSamplerType.SAMPLERTYPE_COLOR, -600, 0)
    library.connect_material_property(colour, "RGB", unreal.MaterialProperty.MP_BASE_COLOR)
    normals = _texture(material, "Normals", unreal.MaterialSamplerType.SAMPLERTYPE_NORMAL, -600, 300)
    library.connect_material_property(normals, "RGB", unreal.MaterialProperty.MP_NORMAL)
    data = library.create_material_expression(material, unreal.MaterialExpressionVertexColor, -900, 600)
    library.connect_material_property(data, "A", unreal.MaterialProperty.MP_AMBIENT_OCCLUSION)
    wind = _wind(material, data)
    library.connect_material_property(wind, "", unreal.MaterialProperty.MP_WORLD_POSITION_OFFSET)
    if is_leaf:
        material.set_editor_property("two_sided", True)
        material.set_editor_property("blend_mode", unreal.BlendMode.BLEND_MASKED)
        material.set_editor_property("shading_model", unreal.MaterialShadingModel.MSM_TWO_SIDED_FOLIAGE)
        library.connect_material_property(colour, "A", unreal.MaterialProperty.MP_OPACITY_MASK)
        library.connect_material_property(colour, "RGB", unreal.MaterialProperty.MP_SUBSURFACE_COLOR)
    library.recompile_material(material)
    return material


def _texture(material, name, kind, x, y):
    """Adds a picture that instances can replace."""
    node = unreal.MaterialEditingLibrary.create_material_expression(
        material, unreal.MaterialExpressionTextureSampleParameter2D, x, y
    )
    node.set_editor_property("parameter_name", name)
    node.set_editor_property("sampler_type", kind)
    if kind == unreal.MaterialSamplerType.SAMPLERTYPE_NORMAL:
        node.set_editor_property("texture", unreal.load_asset("/Engine/EngineMaterials/DefaultNormal"))
    return node


def _wind(material, data):
    """Adds the wind, and returns the node whose output is the offset of a vertex in the world."""
    library = unreal.MaterialEditingLibrary

    def node(kind, x, y, **properties):
        made = library.create_material_expression(material, kind, x, y)
        for key, value in properties.items():
            made.set_editor_property(key, value)
        return made

    inputs = {
        "Data": data,
        "Place": node(unreal.MaterialExpressionLocalPosition, -900, 750),
        "Normal": node(unreal.MaterialExpressionVertexNormalWS, -900, 850),
        "Tree": node(unreal.MaterialExpressionObjectPositionWS, -900, 950),
        "Time": node(unreal.MaterialExpressionTime, -900, 1050),
        "Height": node(unreal.MaterialExpressionScalarParameter, -900, 1150, parameter_name="Height", default_value=1000),
        "Strength": node(unreal.MaterialExpressionScalarParameter, -900, 1250, parameter_name="Strength", default_value=0.5),
        "Direction": node(
            unreal.MaterialExpressionVectorParameter,
            -900,
            1350,
            parameter_name="Direction",
            default_value=unreal.LinearColor(0.8, 0.6, 0, 0),
        ),
    }
    ports = []
    for name in inputs:
        port = unreal.CustomInput()
        port.set_editor_property("input_name", name)
        ports.append(port)
    custom = node(
        unreal.MaterialExpressionCustom,
        -400,
        900,
        code=WIND_CODE,
        description=WIND_NAME,
        inputs=ports,
        output_type=unreal.CustomMaterialOutputType.CMOT_FLOAT3,
    )
    for name, source in inputs.items():
        output = "RGBA" if name == "Data" else "RGB" if name == "Direction" else ""
        library.connect_material_expressions(source, output, custom, name)
    return custom
