/** Meshes and geometry that would take too long, too much memory, or be no numbers. */
const SOLID = "tests/core/spatial/solid_test.cpp";
const MESH_FILE = "tests/web/import/mesh_file/mesh_file.test.ts";
const IN_WORKER = "tests/web/import/mesh_file/read_in_worker.test.ts";

export default [
	{
		file: "wasm-core/src/spatial/solid.cpp",
		suites: [SOLID],
		faults: [
			{
				id: "solid-index-without-bound",
				find: "fits = list_entries(most, entries);",
				replace: "fits = list_entries(most * 1000, entries);",
				breaks: "a dropped mesh of large triangles takes hundreds of megabytes",
			},
			{
				id: "solid-queries-uncounted",
				find: "budget_->spend(looks_four * (end - begin) / lanes + looks_turn * turned);",
				replace: "",
				breaks: "a dropped mesh of 3,200 large triangles grows for half a minute",
			},
			{
				id: "solid-rays-uncounted",
				find: "budget_->spend(looks_meeting * (first_[row + 1] - first_[row]));",
				replace: "",
				breaks: "a text that asks how far it is to the end of a mesh may take longer before it is stopped",
				survives: "between two triangles that a ray meets, the middle is looked up, and that is counted, too",
			},
			{
				id: "solid-goes-on-when-exhausted",
				find: "if (cells_.empty() || is_exhausted()) return false;",
				replace: "if (cells_.empty()) return false;",
				breaks: "what is beyond the bound of work is counted, and done all the same",
			},
			{
				id: "solid-rows-too-few",
				find: "side.at < -side.near;",
				replace: "side.at < side.near;",
				breaks: "places near the sides of large triangles are taken for outside",
			},
		],
	},
	{
		file: "wasm-core/src/models/tree/crown.hpp",
		suites: ["tests/core/models/tree/tree_test.cpp"],
		faults: [
			{
				id: "exhausted-solid-grows-little",
				find: "return crowns_->outer.is_exhausted();",
				replace: "return false;",
				breaks: "a tree in a mesh that takes too long is a few twigs, and nothing says why",
			},
		],
	},
	{
		file: "wasm-core/src/light/density_grid.cpp",
		suites: ["tests/core/light/density_grid_test.cpp"],
		faults: [
			{
				id: "cells-without-end",
				find: "return cells >= 0 && cells < max_along ?",
				replace: "return cells >= 0 ?",
				breaks: "the cells of a box without end take all memory",
			},
		],
	},
	{
		file: "wasm-core/src/mesh/triangulation.cpp",
		suites: ["tests/core/mesh/triangulation_test.cpp"],
		faults: [
			{
				id: "triangulation-steps-uncounted",
				find: "if (steps_left_ > 0) --steps_left_;",
				replace: "",
				breaks: "an outline that takes very many flips is filled however long that takes",
			},
		],
	},
	{
		file: "wasm-core/src/foundation/container.cpp",
		suites: ["tests/core/foundation/container_test.cpp"],
		faults: [
			{
				id: "copies-left-outside",
				find: "return entry.own || size(entry) < large;",
				replace: "return size(entry) < large;",
				breaks: "a plant with very many meshes has names out of memory that was given back",
			},
		],
	},
	{
		file: "wasm-core/src/protocol/answer.cpp",
		suites: ["tests/core/exports/panicle_test.cpp"],
		faults: [
			{
				id: "segment-tags-of-8-bits",
				find: "*at = segment.tag;",
				replace: "*at = segment.tag & 255;",
				breaks: "the 257th volume of a flower has the first one's name",
			},
			{
				id: "organ-tags-of-8-bits",
				find: "*at = organ.tag;",
				replace: "*at = organ.tag & 255;",
				breaks: "the 257th kind of organ has the first one's name",
			},
		],
	},
	{
		file: "wasm-core/src/lsystem/turtle/interpretation.cpp",
		suites: ["tests/core/lsystem/interpretation_test.cpp"],
		faults: [
			{
				id: "turtle-leaves-the-world",
				find: "if (!is_near(turtle_.position))",
				replace: "if (false)",
				breaks: "lines that end farther away than numbers reach are drawn",
			},
			{
				id: "turtle-draws-without-end",
				find: "if (!is_near(size))",
				replace: "if (false)",
				breaks: "a ball enlarged twice has an infinite size",
			},
			{
				id: "turtle-draws-specks",
				find: "else if (std::fabs(size) < least_size)",
				replace: "else if (false)",
				breaks: "what is too small to be drawn is an empty mesh, and nothing says why",
			},
			{
				id: "turtle-lines-wide-without-end",
				find: "else if (!is_near(turtle_.width))",
				replace: "else if (false)",
				breaks: "a line wider than numbers reach is written as values that are no numbers",
			},
			{
				id: "turtle-heads-nowhere",
				find: "else if (!is_unit(turtle_.heading) || !is_unit(turtle_.left))",
				replace: "else if (false)",
				breaks: "what is drawn after a turn by too large numbers has no direction",
			},
		],
	},
	{
		file: "wasm-core/src/plant/geometry_check.cpp",
		suites: ["tests/core/plant/geometry_check_test.cpp"],
		faults: [
			{
				id: "geometry-check-without-normals",
				find: "Rows{all.normals, 3}, ",
				replace: "",
				breaks: "normals that are no numbers reach the page",
			},
			{
				id: "geometry-check-of-first-thousand",
				find: "i < values.size(); i += chunk",
				replace: "i < 1; i += chunk",
				breaks: "of a mesh the first thousand numbers are looked at",
			},
			{
				id: "geometry-check-names-the-first-part",
				find: "vertex - run.first_vertex < run.vertex_count",
				replace: "true",
				breaks: "an error names the first part of a mesh, whichever is broken",
			},
		],
	},
	{
		file: "web/src/import/mesh_file/glb.ts",
		suites: [MESH_FILE],
		faults: [
			{
				id: "glb-stride-of-0",
				find: " || stride < width) throw damaged();",
				replace: ") throw damaged();",
				breaks: "a GLB of 488 bytes whose stride is 0 has a hundred million points",
			},
			{
				id: "glb-beyond-its-view",
				find: "end > byteLength || ",
				replace: "",
				breaks: "points are read out of what lies behind them in the file",
			},
			{
				id: "glb-beyond-its-buffer",
				find: " || start + byteLength > binary.byteLength",
				replace: "",
				breaks: "a GLB that was cut off is read as far as it goes",
			},
			{
				id: "glb-parts-without-bound",
				find: "if (parts > MAX_PARTS)",
				replace: "if (false)",
				breaks: "a GLB of many nodes that have many empty parts is read without an end",
			},
			{
				id: "glb-all-points-of-each-part",
				find: "if (known !== undefined) return known;",
				replace: "",
				breaks: "parts that share points have them as often as they use them",
			},
		],
	},
	{
		file: "web/src/import/mesh_file/text_lines.ts",
		suites: [MESH_FILE],
		faults: [
			{
				id: "obj-lines-end-with-lf",
				find: "text.charCodeAt(end) !== LF && text.charCodeAt(end) !== CR",
				replace: "text.charCodeAt(end) !== LF",
				breaks: "an OBJ whose lines end with CR alone holds no triangles",
			},
			{
				id: "obj-counts-cr-lf-twice",
				find: 'text.startsWith("\\r\\n", end) ? 2 : 1',
				replace: "1",
				breaks: "an error names the line twice as far down",
			},
		],
	},
	{
		file: "web/src/import/mesh_file/obj.ts",
		suites: [MESH_FILE],
		faults: [
			{
				id: "obj-points-without-bound",
				find: "boundedPoints(points.length / 3 + 1);",
				replace: "",
				breaks: "an OBJ of nothing but points takes all memory",
			},
		],
	},
	{
		file: "web/src/import/mesh_file/read_in_worker.ts",
		suites: [IN_WORKER],
		faults: [
			{
				id: "mesh-workers-stay",
				find: "worker.terminate();",
				replace: "",
				breaks: "each mesh that is dropped leaves a worker behind",
			},
		],
	},
];
