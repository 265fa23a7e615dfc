extends Node3D
## Tests the Godot scripts in the engine: prints a line for each check, then DONE.
##
## The project has a game tree as tree.glb, with its description tree.json and the impostor's pictures beside it.

const GameTree := preload("res://addons/panicle/game_tree.gd")
const SIDE := 256


func _ready() -> void:
	var expected: Dictionary = JSON.parse_string(FileAccess.get_file_as_string("res://expected.json"))
	var tree := GameTree.load_tree("res://tree.glb")
	add_child(tree)
	var levels := GameTree.levels_of(tree)
	check("a game tree has its levels, the last one as an impostor", levels.size() == int(expected.levels) - 1
			and tree.has_node("Impostor"), levels.size())
	var begins: Array[float] = []
	var closed := true
	for index in levels.size():
		for part in GameTree.parts_of(levels[index]):
			if begins.size() == index:
				begins.append(part.visibility_range_begin)
				closed = closed and (index == 0 or is_equal_approx(part.visibility_range_begin, last_end))
				last_end = part.visibility_range_end
	check("each level begins where the one before ends", closed and begins[0] == 0.0, begins)
	var first := GameTree.parts_of(levels[0])[0]
	var height := first.get_aabb().end.y
	check("its height is in metres", absf(height - expected.height) < 0.02 * expected.height, height)
	var shaders: Array[String] = []
	for part in GameTree.parts_of(levels[0]):
		for surface in part.mesh.get_surface_count():
			var material := part.get_active_material(surface) as ShaderMaterial
			shaders.append(material.shader.resource_path.get_file() if material else "none")
	shaders.sort()
	check("bark and leaves have their shaders", shaders == ["bark.gdshader", "leaves.gdshader"], shaders)
	var shapes := tree.find_children("*", "CollisionShape3D", true, false)
	check("it has collision in place of the meshes UCX_", shapes.size() == int(expected.shapes)
			and tree.find_children("UCX_*", "MeshInstance3D", true, false).is_empty(), shapes.size())
	await check_ray(expected.height)
	await check_pictures(tree, levels, expected.height)
	check("other scenes stay as they are", not GameTree.set_up(Node3D.new(), "res://tree.glb"), "")
	check("a missing file gives no tree", GameTree.load_tree("res://missing.glb") == null, "")
	print("DONE")


var last_end := 0.0


func check(title: String, passed: bool, found: Variant) -> void:
	print("CHECK ", JSON.stringify({"title": title, "passed": passed, "found": str(found)}))


## A ray meets the trunk, and passes above it.
func check_ray(height: float) -> void:
	await get_tree().physics_frame
	await get_tree().physics_frame
	var space := get_world_3d().direct_space_state
	var across := func(y: float) -> bool:
		var query := PhysicsRayQueryParameters3D.create(Vector3(-20, y, 0), Vector3(20, y, 0))
		return not space.intersect_ray(query).is_empty()
	check("a body cannot pass through the trunk", across.call(0.05 * height) and not across.call(1.5 * height), "")


## Pictures of the tree: the wind moves it, and the impostor has its shape.
func check_pictures(tree: Node3D, levels: Array[Node], height: float) -> void:
	var view := SubViewport.new()
	view.size = Vector2i(SIDE, SIDE)
	view.own_world_3d = true
	view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(view)
	remove_child(tree)
	view.add_child(tree)
	var camera := Camera3D.new()
	camera.fov = 20.0
	view.add_child(camera)
	var surroundings := Environment.new()
	surroundings.background_mode = Environment.BG_COLOR
	surroundings.background_color = Color.WHITE
	surroundings.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	surroundings.ambient_light_color = Color.WHITE
	surroundings.ambient_light_energy = 0.5
	camera.environment = surroundings
	var sun := DirectionalLight3D.new()
	sun.rotation = Vector3(-0.8, 0.6, 0.0)
	view.add_child(sun)
	var parts: Array[GeometryInstance3D] = []
	for level in levels:
		parts.append_array(GameTree.parts_of(level))
	var impostor := tree.get_node_or_null("Impostor") as MeshInstance3D
	if impostor:
		parts.append(impostor)
	for part in parts:
		part.visibility_range_begin = 0.0
		part.visibility_range_end = 0.0
		part.visible = false
	var shown := GameTree.parts_of(levels[0])
	camera.look_at_from_position(Vector3(1.2, 0.6, 2.7) * height, Vector3(0.0, 0.5, 0.0) * height)
	for part in shown:
		part.visible = true
	set_wind(shown, 0.0)
	var calm := await picture(view)

	var covered := coverage(calm)
	check("the tree is visible", covered.count(true) > 500, covered.count(true))
	set_wind(shown, 2.0)
	await get_tree().create_timer(0.4).timeout
	var blown := await picture(view)
	check("the wind moves it", difference(covered, coverage(blown)) > 0.01, difference(covered, coverage(blown)))
	if not impostor:
		return
	for part in shown:
		part.visible = false
	impostor.visible = true
	var flat := await picture(view)
	var apart := distance_of(squares(covered), squares(coverage(flat)))
	check("the impostor has the shape of the tree", apart < 0.35, apart)
	report("tree", calm)
	report("impostor", flat)


func set_wind(parts: Array[MeshInstance3D], strength: float) -> void:
	for part in parts:
		for surface in part.mesh.get_surface_count():
			(part.get_active_material(surface) as ShaderMaterial).set_shader_parameter("wind_strength", strength)


func picture(view: SubViewport) -> Image:
	for frame in 3:
		await RenderingServer.frame_post_draw
	return view.get_texture().get_image()


## Which pixels do not show the white background.
func coverage(image: Image) -> Array[bool]:
	var covered: Array[bool] = []
	for y in SIDE:
		for x in SIDE:
			covered.append(image.get_pixel(x, y).get_luminance() < 0.97)
	return covered


## The share of the pixels in one picture only, of those in any.
func difference(one: Array[bool], other: Array[bool]) -> float:
	var both := 0
	var any := 0
	for index in one.size():
		both += 1 if one[index] and other[index] else 0
		any += 1 if one[index] or other[index] else 0
	return 1.0 - float(both) / maxf(1.0, any)


## The numbers of covered pixels in squares of 16 pixels.
func squares(covered: Array[bool]) -> Array[int]:
	var counts: Array[int] = []
	counts.resize(SIDE * SIDE / 256)
	counts.fill(0)
	for index in covered.size():
		if covered[index]:
			counts[(index / SIDE / 16) * (SIDE / 16) + index % SIDE / 16] += 1
	return counts


## The sum of all differences, as a share of the sum of the larger values.
func distance_of(one: Array[int], other: Array[int]) -> float:
	var apart := 0
	var whole := 0
	for index in one.size():
		apart += absi(one[index] - other[index])
		whole += maxi(one[index], other[index])
	return float(apart) / maxf(1.0, whole)


## Prints a picture for people to look at.
func report(title: String, image: Image) -> void:
	print("PICTURE ", title, " ", Marshalls.raw_to_base64(image.save_png_to_buffer()))
