"""Checks the Unreal script without Unreal Engine: names that are not defined, and the functions that need no engine."""

import ast
import importlib.util
import json
import sys
import types


def check(title, passed, found=""):
    print("CHECK " + json.dumps({"title": title, "passed": bool(passed), "found": str(found)}))


path = sys.argv[1]
with open(path, encoding="utf-8") as file:
    tree = ast.parse(file.read())
defined = {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
called = {node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
missing = sorted(name for name in called - defined if name not in dir(__builtins__))
check("all functions that it calls exist", not missing, missing)
check("each function has a description", all(ast.get_docstring(node) for node in tree.body if isinstance(node, ast.FunctionDef)))

sys.modules["unreal"] = types.ModuleType("unreal")
spec = importlib.util.spec_from_file_location("import_tree", path)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
names = ["UCX_Oak", "Oak_LOD2", "Oak_LOD0", "Other", "Oak_LOD1"]
check("levels are in the order of their numbers", module.levels_of(names) == ["Oak_LOD0", "Oak_LOD1", "Oak_LOD2"])
sizes = module.screen_sizes(6)
check("levels have decreasing screen sizes", sizes[0] == 1 and sizes == sorted(set(sizes), reverse=True), sizes)
try:
    module.run("/nowhere/oak.glb", "/Game/Trees")
    check("a missing file is reported", False)
except FileNotFoundError as error:
    check("a missing file is reported", "does not exist" in str(error))
