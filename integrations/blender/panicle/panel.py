"""The panel in the sidebar of the 3D view: choose a plant, grow it, and choose its level of detail."""

import os
import tempfile

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import importing, levels
from .source import CommandLine, Service, SourceError

# The catalogue of the last source: models with their presets and parameters.
_catalogue = []
# Blender does not keep references to the texts of items that a function returns.
_items = {}


def _model_named(name):
    return next((entry for entry in _catalogue if entry["model"] == name), None)


def _model_items(_, __):
    _items["models"] = [(entry["model"], entry["title"], "") for entry in _catalogue] or [("none", "–", "")]
    return _items["models"]


def _preset_items(settings, _):
    entry = _model_named(settings.model)
    names = entry["presets"] if entry else []
    _items["presets"] = [(name, name.replace("-", " ").capitalize(), "") for name in names] or [("none", "–", "")]
    return _items["presets"]


def _choice_items(parameter, _):
    key = f"choice {parameter.key}"
    _items[key] = [(name, name.capitalize(), "") for name in parameter.options.split("\n") if name] or [("", "–", "")]
    return _items[key]


def _model_changed(settings, _):
    """Lists the parameters of the chosen model, all of them unchanged."""
    settings.parameters.clear()
    entry = _model_named(settings.model)
    for info in entry["parameters"] if entry else []:
        if info["kind"] == "colour":
            continue
        parameter = settings.parameters.add()
        parameter.key, parameter.label, parameter.kind = info["key"], info["label"], info["kind"]
        parameter.unit = info["unit"]
        if info["kind"] == "choice":
            parameter.options = "\n".join(info["options"])
            parameter.choice = info["default"]
        else:
            parameter.least, parameter.most = info["min"], info["max"]
            parameter.number = info["default"]


class PanicleParameter(bpy.types.PropertyGroup):
    """A parameter of the chosen model; only changed ones differ from the preset."""

    key: StringProperty()
    label: StringProperty()
    kind: StringProperty()
    unit: StringProperty()
    options: StringProperty()
    least: FloatProperty()
    most: FloatProperty()
    changed: BoolProperty(name="Change", description="Use this value instead of that of the preset")
    number: FloatProperty(name="Value")
    choice: EnumProperty(name="Value", items=_choice_items)

    def value(self):
        """Returns the value for the source, within its limits."""
        if self.kind == "choice":
            return self.choice
        value = min(self.most, max(self.least, self.number))
        return round(value) if self.kind == "integer" else round(value, 2)


class PanicleSettings(bpy.types.PropertyGroup):
    """The settings of the panel, which are stored in the scene."""

    source: EnumProperty(
        name="Source",
        items=[
            ("SERVICE", "Service", "A running service: npm run service"),
            ("COMMAND", "Command line", "A copy of the repository, after npm ci"),
        ],
    )
    address: StringProperty(name="Address", default="http://127.0.0.1:8765", description="The address of the service")
    folder: StringProperty(name="Folder", subtype="DIR_PATH", description="The folder that contains package.json")
    model: EnumProperty(name="Model", items=_model_items, update=_model_changed)
    preset: EnumProperty(name="Preset", items=_preset_items)
    seed: IntProperty(name="Seed", default=1, min=0)
    form: EnumProperty(
        name="File",
        items=[
            ("glb", "Detailed", "All parts as objects with their names"),
            ("low.glb", "Low poly", "At most 20,000 triangles"),
            ("game.zip", "Game tree", "Four levels of detail, collision and wind; only for trees"),
        ],
    )
    wind: BoolProperty(name="Wind", default=True, description="Let the plant sway, by geometry nodes")
    parameters: CollectionProperty(type=PanicleParameter)


def source_of(settings):
    """Returns the source that the settings name."""
    return Service(settings.address) if settings.source == "SERVICE" else CommandLine(settings.folder)


def load_catalogue(settings):
    """Fetches the models of the source and lists them in the panel."""
    _catalogue[:] = source_of(settings).catalogue()
    names = [entry["model"] for entry in _catalogue]
    settings.model = "growth" if "growth" in names else names[0]
    settings.preset = _model_named(settings.model)["presets"][0]


class PANICLE_OT_load(bpy.types.Operator):
    """Fetch the list of plants from the source"""

    bl_idname = "panicle.load"
    bl_label = "Load plants"

    def execute(self, context):
        try:
            load_catalogue(context.scene.panicle)
        except SourceError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class PANICLE_OT_grow(bpy.types.Operator):
    """Grow the chosen plant and add it to the scene at the 3D cursor"""

    bl_idname = "panicle.grow"
    bl_label = "Grow plant"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.scene.panicle
        if not _model_named(settings.model):
            self.report({"ERROR"}, "Choose “Load plants” first.")
            return {"CANCELLED"}
        changed = {each.key: each.value() for each in settings.parameters if each.changed}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, f"plant.{settings.form.split('.')[-1]}")
            try:
                source = source_of(settings)
                source.write(path, settings.model, settings.preset, settings.seed, changed, settings.form)
                importing.import_plant(path, f"{settings.preset} {settings.seed}", context, settings.wind)
            except (SourceError, RuntimeError, OSError) as error:
                self.report({"ERROR"}, str(error).strip())
                return {"CANCELLED"}
        return {"FINISHED"}


class PANICLE_OT_import(bpy.types.Operator):
    """Import a plant from a file, with its levels, materials and wind"""

    bl_idname = "panicle.import_file"
    bl_label = "Import file…"
    bl_options = {"REGISTER", "UNDO"}

    filepath: StringProperty(subtype="FILE_PATH")
    filter_glob: StringProperty(default="*.glb;*.zip", options={"HIDDEN"})

    def invoke(self, context, _):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        name = os.path.splitext(os.path.basename(self.filepath))[0]
        try:
            importing.import_plant(self.filepath, name, context, context.scene.panicle.wind)
        except FileNotFoundError:
            self.report({"ERROR"}, f"The file “{self.filepath}” does not exist.")
            return {"CANCELLED"}
        except RuntimeError as error:
            self.report({"ERROR"}, str(error).strip())
            return {"CANCELLED"}
        return {"FINISHED"}


class PANICLE_OT_level(bpy.types.Operator):
    """Show this level of detail, and hide the others"""

    bl_idname = "panicle.level"
    bl_label = "Show level"
    bl_options = {"REGISTER", "UNDO"}

    plant: StringProperty()
    level: IntProperty(min=0)

    def execute(self, _):
        plant = bpy.data.collections.get(self.plant)
        if not plant or self.level not in levels.levels_of(plant):
            self.report({"ERROR"}, f"“{self.plant}” has no level {self.level}.")
            return {"CANCELLED"}
        levels.show_level(plant, self.level)
        return {"FINISHED"}


def _plant_of(thing):
    """Returns the collection of the plant of an object, if it has levels."""
    if not thing:
        return None
    return next((each for each in bpy.data.collections if levels.levels_of(each) and thing.name in each.all_objects), None)


class PANICLE_PT_panel(bpy.types.Panel):
    """The panel."""

    bl_label = "Panicle"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Panicle"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        settings = context.scene.panicle
        layout.prop(settings, "source")
        layout.prop(settings, "address" if settings.source == "SERVICE" else "folder")
        layout.operator("panicle.load", icon="FILE_REFRESH")
        if _model_named(settings.model):
            for key in ("model", "preset", "seed", "form", "wind"):
                layout.prop(settings, key)
            layout.operator("panicle.grow", icon="OUTLINER_OB_CURVES")
        layout.operator("panicle.import_file", icon="IMPORT")
        plant = _plant_of(context.object)
        if plant:
            row = layout.row(align=True)
            row.label(text="Level")
            for level in levels.levels_of(plant):
                button = row.operator("panicle.level", text=str(level))
                button.plant, button.level = plant.name, level


class PANICLE_PT_parameters(bpy.types.Panel):
    """The parameters of the chosen model."""

    bl_label = "Parameters"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Panicle"
    bl_parent_id = "PANICLE_PT_panel"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return len(context.scene.panicle.parameters) > 0

    def draw(self, context):
        for parameter in context.scene.panicle.parameters:
            row = self.layout.row()
            unit = f" ({parameter.unit})" if parameter.unit else ""
            row.prop(parameter, "changed", text=parameter.label + unit)
            value = row.row()
            value.enabled = parameter.changed
            value.prop(parameter, "choice" if parameter.kind == "choice" else "number", text="")


CLASSES = (
    PanicleParameter,
    PanicleSettings,
    PANICLE_OT_load,
    PANICLE_OT_grow,
    PANICLE_OT_import,
    PANICLE_OT_level,
    PANICLE_PT_panel,
    PANICLE_PT_parameters,
)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.panicle = PointerProperty(type=PanicleSettings)


def unregister():
    del bpy.types.Scene.panicle
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
