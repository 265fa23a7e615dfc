/** Measures of a bunch. */
const SRC = "wasm-core/src/models/bunch/measures";
const TESTS = "tests/core/models/bunch/measures";

export default [
	{
		file: `${SRC}/measures.cpp`,
		suites: [`${TESTS}/measures_test.cpp`, `${TESTS}/measures_fit_test.cpp`],
		faults: [
			{
				id: "measures-stems-three-times",
				find: "sum += pi / 3 * length",
				replace: "sum += pi * length",
				breaks: "bunches weigh too much by their stems",
			},
			{
				id: "measures-berries-as-water",
				find: "constexpr float berry_density = 1.08f;",
				replace: "constexpr float berry_density = 1.0f;",
				breaks: "berries weigh as if they held no sugar",
			},
			{
				id: "measures-spill-of-the-front",
				find: "ratio(front.spilled + side.spilled,",
				replace: "ratio(front.spilled,",
				breaks: "what hangs out at the side goes untold",
			},
			{
				id: "measures-second-outline-forgotten",
				find: "table[outline_volume] += hung",
				replace: "table[outline_volume] = hung",
				breaks: "a winged bunch is compared with its wing",
			},
		],
	},
	{
		file: `${SRC}/images/measures_compactness.cpp`,
		suites: [`${TESTS}/measures_compactness_test.cpp`],
		faults: [
			{
				id: "compactness-far-ones-touch",
				find: "constexpr float touching = 0.03f;",
				replace: "constexpr float touching = 0.6f;",
				breaks: "loose bunches count as touching everywhere",
			},
			{
				id: "compactness-fingers-as-balls",
				find: "return (support + 1 / std::sqrt(inverse)) / 2;",
				replace: "return berry.half_width;",
				breaks: "gaps between fingers are wrong by their length",
			},
		],
	},
	{
		file: `${SRC}/measures_form.cpp`,
		suites: [`${TESTS}/measures_form_test.cpp`],
		faults: [
			{
				id: "form-no-horns",
				find: "if (form.curve >= horn) return 9;",
				replace: "",
				breaks: "Pizzutello's berries are said to be fingers",
			},
			{
				id: "form-uniform-reversed",
				find: "spread <= uniform_spread ? 2 : 1",
				replace: "spread <= uniform_spread ? 1 : 2",
				breaks: "uniform bunches are said to be uneven",
			},
			{
				id: "form-never-a-cylinder",
				find: "if (lower >= cylinder * upper) return 1;",
				replace: "",
				breaks: "cylinders are said to be cones",
			},
		],
	},
	{
		file: `${SRC}/images/measures_visibility.cpp`,
		suites: [`${TESTS}/measures_visibility_test.cpp`],
		faults: [
			{
				id: "visibility-from-the-right",
				find: "if (face && x == -1)",
				replace: "if (face && x == 1)",
				breaks: "the side's share is the other side's",
			},
			{
				id: "visibility-far-ones-first",
				find: "std::tie(other.depth, place.y, place.x, berry) < std::tie(depth, other.place.y, other.place.x, other.berry)",
				replace: "depth < other.depth",
				breaks: "hidden berries count as seen",
			},
		],
	},
	{
		file: `${SRC}/measures_fit.cpp`,
		suites: [`${TESTS}/measures_fit_test.cpp`],
		faults: [
			{
				id: "fit-lean-reversed",
				find: "return {turn.cosine, sign * turn.sine}; }",
				replace: "return {turn.cosine, -sign * turn.sine}; }",
				breaks: "a leaning wing is compared with one that leans the other way",
			},
		],
	},
	{
		file: `${SRC}/images/silhouette.cpp`,
		suites: [`${TESTS}/silhouette_test.cpp`],
		faults: [
			{
				id: "silhouette-thin-stems",
				find: "add_edge(stretch, corners[i], corners[(i + 1) % 4], y);",
				replace: ";",
				breaks: "stems are drawn as their two ends",
			},
		],
	},
];
