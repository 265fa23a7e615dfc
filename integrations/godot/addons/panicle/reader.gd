@tool
extends GLTFDocumentExtension
## Reads the parts of a game tree that Godot's importer leaves out: it shows only the first scene, which has the finest
## level alone, and knows only the first vertex colours, while the second ones contain the wind data.


func _import_preflight(state: GLTFState, _extensions: PackedStringArray) -> Error:
	var json := state.json
	var index := _scene_with_levels(json)
	if index < 0:
		return ERR_SKIP
	json["scene"] = index
	for mesh: Dictionary in json.get("meshes", []):
		for primitive: Dictionary in mesh.primitives:
			var attributes: Dictionary = primitive.attributes
			if attributes.has("COLOR_1"):
				attributes["COLOR_0"] = attributes["COLOR_1"]
				attributes.erase("COLOR_1")
	return OK


## Returns the scene of a glTF document with the most nodes that are levels, or -1 if there is none.
static func _scene_with_levels(json: Dictionary) -> int:
	var best := -1
	var most := 0
	var scenes: Array = json.get("scenes", [])
	for index in scenes.size():
		var count := 0
		for node: int in scenes[index].get("nodes", []):
			if "_LOD" in str(json.nodes[node].get("name", "")):
				count += 1
		if count > most:
			most = count
			best = index
	return best
