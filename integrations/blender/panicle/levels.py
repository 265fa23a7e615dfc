"""Levels of detail of a plant: a collection for each level, of which one is visible, and the collision shape."""

import re

import bpy

LEVEL = re.compile(r"_LOD(\d)(?:\.\d+)?$")
COLLISION = re.compile(r"^UCX_")


def level_of(thing):
    """Returns the level of an object by its name or that of a parent, or None."""
    while thing:
        found = LEVEL.search(thing.name)
        if found:
            return int(found.group(1))
        thing = thing.parent
    return None


def is_collision(thing):
    """Whether an object is a collision shape."""
    return bool(COLLISION.match(thing.name))


def arrange(objects, name, into):
    """Moves the objects of a plant into collections, and returns the collection of the plant.

    The plant's collection has one collection per level; the finest is visible. A plant without levels has only its
    own collection.
    """
    plant = bpy.data.collections.new(name)
    into.children.link(plant)
    children = {}
    for thing in objects:
        level = level_of(thing)
        if is_collision(thing):
            key = "Collision"
            thing.display_type = "WIRE"
        else:
            key = None if level is None else f"LOD{level}"
        if key is None:
            target = plant
        else:
            if key not in children:
                children[key] = bpy.data.collections.new(f"{name} {key}")
            target = children[key]
        for collection in list(thing.users_collection):
            collection.objects.unlink(thing)
        target.objects.link(thing)
    for key in sorted(children):
        plant.children.link(children[key])
    finest = next((int(key[3:]) for key in sorted(children) if key != "Collision"), 0)
    show_level(plant, finest)
    return plant


def show_level(plant, level):
    """Shows one level of a plant, in the view and in renders, and hides the others and the collision shape."""
    for child in plant.children:
        part = child.name[len(plant.name) + 1 :]
        hidden = part != f"LOD{level}"
        child.hide_render = hidden
        child.hide_viewport = hidden


def levels_of(plant):
    """Returns the numbers of the levels of a plant."""
    parts = [child.name[len(plant.name) + 1 :] for child in plant.children]
    return sorted(int(part[3:]) for part in parts if re.fullmatch(r"LOD\d", part))
