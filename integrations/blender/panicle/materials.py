"""Materials of a plant: colours without wind data, and leaves through which light shines."""

# Share of the light that passes through a leaf.
TRANSLUCENCY = 0.35


def set_up(material, has_wind):
    """Changes a material that the glTF importer made.

    The importer multiplies the colour by the first vertex colours. Where these contain wind data, only their alpha, the
    occlusion, may darken the plant.
    """
    if not material.node_tree:
        return
    if has_wind:
        _use_occlusion(material)
    if is_sheet(material):
        material.use_backface_culling = False
        _shine_through(material)


def is_sheet(material):
    """Whether a material is that of leaves or petals, which glTF marks as double-sided."""
    return not material.use_backface_culling


def _use_occlusion(material):
    """Replaces the vertex colours in the base colour by their alpha."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    for node in [each for each in nodes if each.type == "VERTEX_COLOR"]:
        for link in list(node.outputs["Color"].links):
            target = link.to_socket
            links.remove(link)
            links.new(node.outputs["Alpha"], target)
        # Opacity is in the picture.
        for link in [each for each in node.outputs["Alpha"].links if _leads_to_alpha(each)]:
            socket = link.to_socket
            links.remove(link)
            socket.default_value = 1.0


def _leads_to_alpha(link):
    """Whether a link only affects the opacity: it ends in a computation that feeds the input Alpha."""
    node = link.to_node
    if node.type == "BSDF_PRINCIPLED":
        return link.to_socket.name == "Alpha"
    if node.type != "MATH":
        return False
    return any(_leads_to_alpha(each) for output in node.outputs for each in output.links)


def _shine_through(material):
    """Mixes a translucent shader with the surface, in the colour of the leaf."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    if any(node.type == "BSDF_TRANSLUCENT" for node in nodes):
        return
    output = next((node for node in nodes if node.type == "OUTPUT_MATERIAL"), None)
    surface = next((node for node in nodes if node.type == "BSDF_PRINCIPLED"), None)
    if not output or not surface:
        return
    colour, alpha = surface.inputs["Base Color"], surface.inputs["Alpha"]
    glow = nodes.new("ShaderNodeBsdfTranslucent")
    opaque = nodes.new("ShaderNodeMixShader")
    opaque.inputs["Fac"].default_value = TRANSLUCENCY
    _copy_input(links, colour, glow.inputs["Color"])
    links.new(surface.outputs["BSDF"], opaque.inputs[1])
    links.new(glow.outputs["BSDF"], opaque.inputs[2])
    result = opaque
    if alpha.is_linked:
        # The cut-out applies to the translucent part, too.
        clear = nodes.new("ShaderNodeBsdfTransparent")
        result = nodes.new("ShaderNodeMixShader")
        _copy_input(links, alpha, result.inputs["Fac"])
        links.remove(alpha.links[0])
        alpha.default_value = 1.0
        links.new(clear.outputs["BSDF"], result.inputs[1])
        links.new(opaque.outputs["Shader"], result.inputs[2])
    links.new(result.outputs["Shader"], output.inputs["Surface"])
    for index, node in enumerate((glow, opaque, result)):
        node.location = (surface.location.x + 320 + 200 * index, surface.location.y - 160)
    output.location.x = result.location.x + 220


def _copy_input(links, source, target):
    """Gives a socket the same input as another one."""
    if source.is_linked:
        links.new(source.links[0].from_socket, target)
    else:
        target.default_value = source.default_value
