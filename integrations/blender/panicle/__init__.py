"""Panicle for Blender: grows plants, and sets up their levels of detail, materials and wind."""

from . import panel


def register():
    panel.register()


def unregister():
    panel.unregister()
