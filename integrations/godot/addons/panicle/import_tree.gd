@tool
extends EditorScenePostImport
## An import script for game trees: choose it in the Import dock of a GLB. Other scenes stay as they are.

const GameTree := preload("game_tree.gd")


func _post_import(scene: Node) -> Object:
	GameTree.set_up(scene, get_source_file())
	return scene
