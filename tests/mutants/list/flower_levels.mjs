/** Flowers for four distances, and how meshes are thinned. */
export default [
	{
		file: "wasm-core/src/models/flower/levels.cpp",
		suites: ["tests/core/models/flower/levels_test.cpp"],
		faults: [
			{
				id: "flower-levels-by-own-luck",
				find: "usual.steps = given.steps;",
				replace: "usual = given;",
				breaks: "what a level leaves out hangs on the seed and the age, and plants of one map have other triangles",
			},
			{
				id: "flower-levels-all-unlike",
				find: "i < strides.size() && triangles(retained, no_limit) > most;",
				replace: "false;",
				breaks: "organs that are all unlike are never too many, and a flower afar has thousands of triangles",
			},
			{
				id: "flower-levels-painted-by-neighbours",
				find: "while (*at != invalid && of_[*at].number != number) at = &of_[*at].next;",
				replace: "",
				breaks: "in a bed petals have their stem's place in the picture where they meet it",
			},
		],
	},
	{
		file: "wasm-core/src/models/flower/level.cpp",
		suites: ["tests/core/models/flower/levels_test.cpp"],
		faults: [
			{
				id: "flower-levels-crowd-stays-narrow",
				find: "place = foot_point + times * (place - foot_point);",
				replace: "place = foot_point + (place - foot_point);",
				breaks: "what is left of a crowd from afar is as wide as near by, and its colour is gone",
			},
		],
	},
	{
		file: "wasm-core/src/mesh/simplification.cpp",
		suites: ["tests/core/mesh/simplification_test.cpp"],
		faults: [
			{
				id: "thinning-compares-all",
				find: "if (patch.triangles.size() > most) return merged_on_grids(patch);",
				replace: "",
				breaks: "the levels of a large flower take 10 s",
			},
			{
				id: "thinning-turns-over",
				find: "if (turns_triangle(vertex, into)) continue;",
				replace: "",
				breaks: "a level has triangles that face inwards",
			},
			{
				id: "thinning-error-falls",
				find: "error = std::max(error, static_cast<float>(std::sqrt(cost)));",
				replace: "error = static_cast<float>(std::sqrt(cost));",
				breaks: "a list of collapses cannot be cut at an error",
			},
			{
				id: "thinning-fixed-goes",
				find: "patch_.is_fixed[vertex] != 0 || ",
				replace: "",
				breaks: "organs come off what bears them",
			},
			{
				id: "thinning-closing-counts",
				find: "left_ -= t < patch_.counted;",
				replace: "--left_;",
				breaks: "what only closes a patch counts as its triangles",
			},
		],
	},
];
