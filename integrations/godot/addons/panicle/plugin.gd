@tool
extends EditorPlugin
## Lets the editor read all levels of game trees when it imports them.

const Reader := preload("reader.gd")

var _reader: GLTFDocumentExtension


func _enter_tree() -> void:
	_reader = Reader.new()
	GLTFDocument.register_gltf_document_extension(_reader, true)


func _exit_tree() -> void:
	GLTFDocument.unregister_gltf_document_extension(_reader)
