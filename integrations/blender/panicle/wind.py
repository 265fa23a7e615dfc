"""Wind as geometry nodes, from the vertex data of a plant: branch phase, branch weight and leaf phase in the colours."""

import math

import bpy

GROUP = "Panicle wind"
# Names that the glTF importer gives to COLOR_0 and COLOR_1.
FIRST_COLOURS, SECOND_COLOURS = "Color", "Color.001"


def data_of(mesh):
    """Returns the name of the colours of a mesh that are wind data: the second ones, or else the first; or None."""
    return next((name for name in (SECOND_COLOURS, FIRST_COLOURS) if name in mesh.color_attributes), None)


def add(thing, height, strength=0.5):
    """Adds the wind to an object, as a modifier whose strength can be animated; returns the modifier."""
    modifier = thing.modifiers.new("Wind", "NODES")
    modifier.node_group = _group()
    set_input(modifier, "Data", data_of(thing.data))
    set_input(modifier, "Height", height)
    set_input(modifier, "Strength", strength)
    return modifier


def set_input(modifier, name, value):
    """Sets an input of the modifier by the name of the input."""
    for item in modifier.node_group.interface.items_tree:
        if item.item_type == "SOCKET" and item.in_out == "INPUT" and item.name == name:
            modifier[item.identifier] = value
            return
    raise KeyError(name)


def _group():
    """Returns the node group of the wind, which is made once per file."""
    known = bpy.data.node_groups.get(GROUP)
    if known:
        return known
    group = bpy.data.node_groups.new(GROUP, "GeometryNodeTree")
    _Wind(group).build()
    return group


class _Wind:
    """Builds the nodes.

    The trunk bends with the square of the height, a branch swings by its weight at its own phase, and a leaf flutters
    along its normal. All motion repeats after `PERIOD` seconds, so that an animation of that length loops.
    """

    PERIOD = 10

    def __init__(self, group):
        self.nodes, self.links, self.interface = group.nodes, group.links, group.interface

    def build(self):
        """Adds all nodes to the empty group."""
        self._socket("Geometry", "INPUT", "NodeSocketGeometry")
        self._socket("Strength", "INPUT", "NodeSocketFloat", 0.5, 0, 2)
        self._socket("Height", "INPUT", "NodeSocketFloat", 10, 0.01, 200)
        self._socket("Direction", "INPUT", "NodeSocketFloat", 0.6, -math.tau, math.tau)
        self._socket("Data", "INPUT", "NodeSocketString")
        self._socket("Geometry", "OUTPUT", "NodeSocketGeometry")
        inputs = self.nodes.new("NodeGroupInput").outputs
        time = self.nodes.new("GeometryNodeInputSceneTime").outputs["Seconds"]
        colours = self.nodes.new("GeometryNodeInputNamedAttribute")
        colours.data_type = "FLOAT_COLOR"
        self.links.new(inputs["Data"], colours.inputs["Name"])
        parts = self.nodes.new("FunctionNodeSeparateColor")
        self.links.new(self._output(colours, "Attribute"), parts.inputs["Color"])
        phase, weight, leaf = (parts.outputs[name] for name in ("Red", "Green", "Blue"))
        position = self.nodes.new("GeometryNodeInputPosition").outputs[0]
        place = self.nodes.new("ShaderNodeSeparateXYZ")
        self.links.new(position, place.inputs[0])
        height = inputs["Height"]
        share = self._math("DIVIDE", place.outputs["Z"], height, clamp=True)
        square = self._math("MULTIPLY", share, share)
        size = self._math("MULTIPLY", height, 0.022)
        rhythm = self._math("MULTIPLY_ADD", self._wave(time, 2, None), 0.4, 0.6)
        trunk = self._math("MULTIPLY", self._math("MULTIPLY", size, square), rhythm)
        branch = self._math("MULTIPLY", self._math("MULTIPLY", size, weight), self._wave(time, 3, phase))
        is_leaf = self._math("GREATER_THAN", leaf, 0.001)
        flutter = self._math("MULTIPLY", self._math("MULTIPLY", 0.03, is_leaf), self._wave(time, 11, leaf))
        along, across = self._math("COSINE", inputs["Direction"]), self._math("SINE", inputs["Direction"])
        push = self._math("MULTIPLY_ADD", branch, 0.7, trunk)
        side = self._math("MULTIPLY", branch, 0.5)
        x = self._math("SUBTRACT", self._math("MULTIPLY", push, along), self._math("MULTIPLY", side, across))
        y = self._math("ADD", self._math("MULTIPLY", push, across), self._math("MULTIPLY", side, along))
        sway = self.nodes.new("ShaderNodeCombineXYZ")
        for value, socket in ((x, "X"), (y, "Y"), (self._math("MULTIPLY", branch, 0.4), "Z")):
            self.links.new(value, sway.inputs[socket])
        normal = self.nodes.new("GeometryNodeInputNormal").outputs["Normal"]
        leaves = self._scaled(normal, flutter)
        total = self.nodes.new("ShaderNodeVectorMath")
        self.links.new(sway.outputs[0], total.inputs[0])
        self.links.new(leaves, total.inputs[1])
        move = self.nodes.new("GeometryNodeSetPosition")
        self.links.new(inputs["Geometry"], move.inputs["Geometry"])
        self.links.new(self._scaled(total.outputs[0], inputs["Strength"]), move.inputs["Offset"])
        self.links.new(move.outputs["Geometry"], self.nodes.new("NodeGroupOutput").inputs["Geometry"])

    def _socket(self, name, kind, type_name, value=None, low=None, high=None):
        socket = self.interface.new_socket(name, in_out=kind, socket_type=type_name)
        if value is not None:
            socket.default_value, socket.min_value, socket.max_value = value, low, high

    @staticmethod
    def _output(node, name):
        """Returns the enabled output of a name: nodes have one for each type of data."""
        return next(each for each in node.outputs if each.name == name and each.enabled)

    def _math(self, operation, *operands, clamp=False):
        node = self.nodes.new("ShaderNodeMath")
        node.operation = operation
        node.use_clamp = clamp
        for socket, operand in zip(node.inputs, operands):
            if isinstance(operand, (int, float)):
                socket.default_value = operand
            else:
                self.links.new(operand, socket)
        return node.outputs[0]

    def _scaled(self, vector, factor):
        node = self.nodes.new("ShaderNodeVectorMath")
        node.operation = "SCALE"
        self.links.new(vector, node.inputs[0])
        self.links.new(factor, node.inputs["Scale"])
        return node.outputs[0]

    def _wave(self, time, turns, phase):
        """Returns a sine with so many turns per period, at a phase of 0 … 1."""
        angle = self._math("MULTIPLY", time, math.tau * turns / self.PERIOD)
        if phase is not None:
            angle = self._math("MULTIPLY_ADD", phase, math.tau, angle)
        return self._math("SINE", angle)
