@tool
extends RefCounted
## Sets up a game tree from Panicle: visibility ranges of its levels, materials with wind, collision and the impostor.
##
## The import script calls [method set_up] for each imported scene. A game that loads trees while it runs can call
## [method load_tree] instead.

const Reader := preload("reader.gd")
const BARK := preload("bark.gdshader")
const LEAVES := preload("leaves.gdshader")
const IMPOSTOR := preload("impostor.gdshader")
## The shares of the view's height at which a tree changes to the next level, if it has no description.
const SCREEN_SIZES: Array[float] = [0.75, 0.26, 0.085]
## The vertical field of view for which the ranges hold, in degrees: that of a new Camera3D.
const FIELD_OF_VIEW := 75.0
## The overlap of the ranges of two levels, as a share of the distance.
const MARGIN := 0.05
## The prefix of collision shapes.
const COLLISION := "UCX_"


## Loads a game tree from a GLB file and the files beside it. Returns null, with an error, if this is impossible.
static func load_tree(path: String) -> Node3D:
	var state := GLTFState.new()
	var document := GLTFDocument.new()
	var reader := Reader.new()
	GLTFDocument.register_gltf_document_extension(reader, true)
	var problem := document.append_from_file(path, state)
	GLTFDocument.unregister_gltf_document_extension(reader)
	if problem != OK:
		push_error("Panicle: %s cannot be read (%s)." % [path, error_string(problem)])
		return null
	var scene := document.generate_scene(state) as Node3D
	set_up(scene, path)
	return scene


## Sets up a scene, and returns whether it is a game tree.
## [param path] is that of the GLB file, beside which the description and the pictures of the impostor are.
static func set_up(scene: Node, path: String) -> bool:
	var levels := levels_of(scene)
	if levels.is_empty():
		return false
	var height := 0.0
	for part in parts_of(levels[0]):
		height = maxf(height, part.get_aabb().end.y)
	var description := _description_of(path)
	var impostor := _impostor_of(description, path.get_base_dir())
	if impostor and levels.size() > 1:
		# The last level shows the same pictures without a shader.
		var last: Node = levels.pop_back()
		last.get_parent().remove_child(last)
		last.free()
	var ranges := ranges_of(levels.size() + (1 if impostor else 0), height, _sizes_of(description))
	for index in levels.size():
		for part in parts_of(levels[index]):
			_set_range(part, ranges[index], ranges[index + 1])
			for surface in part.mesh.get_surface_count():
				part.set_surface_override_material(surface, _material_of(part.mesh, surface, height))
	if impostor:
		impostor.name = "Impostor"
		_set_range(impostor, ranges[levels.size()], 0.0)
		scene.add_child(impostor)
		impostor.owner = scene
	_set_up_collision(scene)
	return true


## Returns the levels of a scene, the finest first.
static func levels_of(scene: Node) -> Array[Node]:
	var name_pattern := RegEx.create_from_string("_LOD(\\d)$")
	var found: Dictionary[int, Node] = {}
	for node: Node in scene.find_children("*_LOD?", "", true, false):
		var result := name_pattern.search(node.name)
		if result:
			found[result.get_string(1).to_int()] = node
	var numbers := found.keys()
	numbers.sort()
	var levels: Array[Node] = []
	for number: int in numbers:
		levels.append(found[number])
	return levels


## Returns the meshes of a level.
static func parts_of(level: Node) -> Array[MeshInstance3D]:
	var parts: Array[MeshInstance3D] = []
	if level is MeshInstance3D:
		parts.append(level)
	for node in level.find_children("*", "MeshInstance3D", true, false):
		parts.append(node)
	return parts


## Returns the distances at which each level begins, and 0 for the last one's end, which has no limit.
static func ranges_of(count: int, height: float, sizes: Array[float] = SCREEN_SIZES) -> Array[float]:
	var ranges: Array[float] = [0.0]
	for index in count - 1:
		var size := sizes[mini(index, sizes.size() - 1)]
		ranges.append(height / (2.0 * size * tan(deg_to_rad(0.5 * FIELD_OF_VIEW))))
	ranges.append(0.0)
	return ranges


## Returns the description in the JSON beside a GLB file; empty if there is none.
static func _description_of(path: String) -> Dictionary:
	var file := path.get_basename() + ".json"
	if not FileAccess.file_exists(file):
		return {}
	var description: Variant = JSON.parse_string(FileAccess.get_file_as_string(file))
	return description if description is Dictionary else {}


## Returns the shares of the view's height at which a tree changes levels; the description has shares of its area.
static func _sizes_of(description: Dictionary) -> Array[float]:
	var sizes: Array[float] = []
	for level: Dictionary in description.get("levels", []):
		if level.get("screenCoverage", 0.0) > 0.0:
			sizes.append(sqrt(level.screenCoverage))
	return SCREEN_SIZES if sizes.is_empty() else sizes


## Returns the impostor that a description has, with the pictures of a folder, or null if there is none.
static func _impostor_of(description: Dictionary, folder: String) -> MeshInstance3D:
	if not description.get("impostor") is Dictionary:
		return null
	var info: Dictionary = description.impostor
	var colour := _picture(folder.path_join(info.colour))
	var surface := _picture(folder.path_join(info.surface))
	if not colour or not surface:
		return null
	var centre := Vector3(info.middle[0], info.middle[1], info.middle[2])
	var material := ShaderMaterial.new()
	material.resource_name = "Impostor"
	material.shader = IMPOSTOR
	material.set_shader_parameter("colour_picture", colour)
	material.set_shader_parameter("surface_picture", surface)
	material.set_shader_parameter("centre", centre)
	material.set_shader_parameter("radius", info.radius)
	material.set_shader_parameter("frames", info.frames)
	var quad := QuadMesh.new()
	quad.size = Vector2(2.0, 2.0)
	quad.material = material
	# The shader moves the corners: this box contains the square in all directions.
	quad.custom_aabb = AABB(centre - info.radius * Vector3.ONE, 2.0 * info.radius * Vector3.ONE)
	var impostor := MeshInstance3D.new()
	impostor.mesh = quad
	return impostor


## Returns the picture of a file, imported by the editor or not; null, with an error, if there is none.
static func _picture(path: String) -> Texture2D:
	if ResourceLoader.exists(path, "Texture2D"):
		return load(path)
	var image := Image.new()
	if not FileAccess.file_exists(path) or image.load_png_from_buffer(FileAccess.get_file_as_bytes(path)) != OK:
		push_error("Panicle: the picture %s is missing. Copy all files of the archive, and import again." % path)
		return null
	image.generate_mipmaps()
	return ImageTexture.create_from_image(image)


static func _set_range(part: GeometryInstance3D, begin: float, end: float) -> void:
	part.visibility_range_begin = begin
	part.visibility_range_end = end
	part.visibility_range_begin_margin = MARGIN * begin
	part.visibility_range_end_margin = MARGIN * end
	part.visibility_range_fade_mode = GeometryInstance3D.VISIBILITY_RANGE_FADE_SELF


## Returns a material with wind in place of the one that the importer made.
static func _material_of(mesh: Mesh, surface: int, height: float) -> Material:
	var old := mesh.surface_get_material(surface) as BaseMaterial3D
	if not old:
		return mesh.surface_get_material(surface)
	var is_leaf := old.cull_mode == BaseMaterial3D.CULL_DISABLED
	var material := ShaderMaterial.new()
	material.resource_name = old.resource_name
	material.shader = LEAVES if is_leaf else BARK
	material.set_shader_parameter("albedo", old.albedo_color)
	material.set_shader_parameter("roughness", old.roughness)
	material.set_shader_parameter("tree_height", height)
	if old.albedo_texture:
		material.set_shader_parameter("albedo_picture", old.albedo_texture)
	if old.normal_enabled and old.normal_texture:
		material.set_shader_parameter("normal_picture", old.normal_texture)
	if is_leaf and old.transparency == BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR:
		material.set_shader_parameter("alpha_cutoff", old.alpha_scissor_threshold)
	var arrays := mesh as ArrayMesh
	if arrays and not arrays.surface_get_format(surface) & Mesh.ARRAY_FORMAT_COLOR:
		# Without wind data all vertices would move alike.
		material.set_shader_parameter("wind_strength", 0.0)
	return material


## Replaces the collision meshes by a static body with convex shapes.
static func _set_up_collision(scene: Node) -> void:
	var shapes: Array[Node] = scene.find_children(COLLISION + "*", "MeshInstance3D", true, false)
	if shapes.is_empty():
		return
	var body := StaticBody3D.new()
	body.name = "Collision"
	scene.add_child(body)
	body.owner = scene
	for node: MeshInstance3D in shapes:
		var shape := CollisionShape3D.new()
		shape.name = node.name
		shape.shape = node.mesh.create_convex_shape(true, false)
		shape.transform = _transform_in(scene, node)
		node.get_parent().remove_child(node)
		node.free()
		body.add_child(shape)
		shape.owner = scene


## Returns the transform of a node in a scene that need not be in the tree.
static func _transform_in(scene: Node, node: Node3D) -> Transform3D:
	var result := node.transform
	var parent := node.get_parent()
	while parent and parent != scene:
		if parent is Node3D:
			result = (parent as Node3D).transform * result
		parent = parent.get_parent()
	return result
