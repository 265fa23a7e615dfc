/** The natural procedure until berries swell: plan, stems, flowers. */
const SRC = "wasm-core/src/models/bunch/natural";
const TESTS = "tests/core/models/bunch/natural";

export default [
	{
		file: `${SRC}/natural.cpp`,
		suites: [`${TESTS}/natural_berries_test.cpp`],
		faults: [
			{
				id: "natural-berries-all-as-fine",
				find: "const float pixels = view * radius / std::max({extent.x, extent.y, extent.z});",
				replace: "const float pixels = 40;",
				breaks: "flowers of a millimetre have as many triangles as ripe berries",
			},
		],
	},
	{
		file: `${SRC}/natural_plan.cpp`,
		suites: [`${TESTS}/second_order_test.cpp`],
		faults: [
			{
				id: "plan-shoulders-do-not-branch",
				find: "if (turn.cosine < 0) return 0;",
				replace: "return 0;",
				breaks: "end structures of shoulders never go on as axes of second order",
			},
			{
				id: "plan-no-lengths-beyond-its-nodes",
				find: "beyonds.resize(beyonds.size() + max_nodes, 0);",
				replace: "",
				breaks: "a text whose axes are longer than the plan's asks for a length that is not there",
			},
		],
	},
	{
		file: `${SRC}/hanging.cpp`,
		suites: [`${TESTS}/hanging_test.cpp`],
		faults: [
			{
				id: "hanging-rachis-bends-as-an-axis",
				find: "rachis = 0.1f",
				replace: "rachis = 0.7f",
				breaks: "the whole bunch sways aside",
			},
			{
				id: "hanging-axes-hang-on-themselves",
				find: "internode.parent < 0 ? -1 : hanging.branch_of[parent];",
				replace: "-1;",
				breaks: "branches do not follow the branch that bears them",
			},
		],
	},
	{
		file: `${SRC}/sprout.cpp`,
		suites: [`${TESTS}/sprout_test.cpp`, `${TESTS}/wing_test.cpp`],
		faults: [
			{
				id: "sprout-wing-of-the-same-seed",
				find: "draw_one(scaled(profile, wing), second_seed(request_.seed), ",
				replace: "draw_one(scaled(profile, wing), request_.seed, ",
				breaks: "the wing branches as the bunch does",
			},
			{
				id: "sprout-stalk-without-counted",
				find: "counted ? wing.envelope.volume() / (wing.envelope.volume() + bunch.envelope.volume()) : 1",
				replace: "counted ? 0 : 1",
				breaks: "a wing of a bunch with a given count stands out as if nothing hung from it",
			},
			{
				id: "sprout-unit-ignored",
				find: "scale(internode, unit);",
				replace: "",
				breaks: "stems keep their size as the scale shrinks",
			},
		],
	},
	{
		file: `${SRC}/flowers.cpp`,
		suites: [`${TESTS}/flowers_test.cpp`],
		faults: [
			{
				id: "flowers-joints-count-as-organs",
				find: "(one.joint ? 0 : 1)",
				replace: "1",
				breaks: "a pedicel drawn in two pieces sets by another turn",
			},
			{
				id: "flowers-strength-without-bounds",
				find: "std::clamp(balls[i].radius, least_strength, 1.0f)",
				replace: "balls[i].radius",
				breaks: "a text's spheres of radius 25 outdo all others",
			},
		],
	},
	{
		file: `${SRC}/natural_plan.cpp`,
		suites: [`${TESTS}/natural_plan_test.cpp`],
		faults: [
			{
				id: "natural-plan-count-unheeded",
				find: "plan.berries = std::min(is_count_requested(values) ? values[Parameter::count] : filling, max_berries);",
				replace: "plan.berries = std::min(filling, max_berries);",
				breaks: "the slider of the count does nothing",
			},
			{
				id: "natural-plan-axes-beyond-the-outline",
				find: "hung_from(plan, angle, end)));",
				replace: "{}));",
				breaks: "berries stand out of the profile",
			},
			{
				id: "natural-plan-axes-upwards",
				find: "std::min(max_upward, arc_tangent(out, down) * (180 / pi))",
				replace: "150.0f",
				breaks: "axes grow up past the peduncle",
			},
			{
				id: "natural-plan-four-planes",
				find: "start + text.turn * static_cast<float>(k)",
				replace: "90.0f * static_cast<float>(k)",
				breaks: "every view of a bunch shows columns and a seam",
			},
			{
				id: "natural-plan-wide-sides-no-nearer",
				find: "arc_tangent(along * direction.sine, across * direction.cosine)",
				replace: "arc_tangent(direction.sine, direction.cosine)",
				breaks: "a flat bunch has as many axes to its narrow sides",
			},
			{
				id: "natural-plan-fill-in-steps",
				find: "(place - static_cast<float>(below))",
				replace: "0.0f",
				breaks: "density moves in nine steps",
			},
		],
	},
	{
		file: `${SRC}/settling/sagging.cpp`,
		suites: [`${TESTS}/sagging_test.cpp`],
		faults: [
			{
				id: "sagging-turned-once",
				find: "if (weight == turned_by_) return turned_;",
				replace: "if (turned_by_ >= 0) return turned_;",
				breaks: "axes stay as they hang under the first size of berry that is asked for",
			},
			{
				id: "sagging-upright-pedicels-stand",
				find: "(limp + limper * heading.y)",
				replace: "limp",
				breaks: "berries on top of a bunch stand up",
			},
			{
				id: "sagging-full-berries-swing-down",
				find: "std::min(1.0f, size / hung_at)",
				replace: "size",
				breaks: "a pixel of the profile sends berries past each other",
			},
			{
				id: "sagging-stout-axes-bend-as-thin-ones",
				find: "/ (radius_squared * radius_squared)",
				replace: "",
				breaks: "a shoulder's axis bends like a twig",
			},
			{
				id: "sagging-late-berries-weigh",
				find: "if (berry.late) continue;",
				replace: "",
				breaks: "axes bend under berries that are not there",
			},
			{
				id: "sagging-young-axes-not-braced",
				find: "braced_[k] = least_turn(after[k], before[k]);",
				replace: "continue;",
				breaks: "ripe bunches hang out of their outline",
			},
			{
				id: "sagging-moments-stay-on-twigs",
				find: "moments[static_cast<std::size_t>(branch.parent)] += moments[k];",
				replace: "",
				breaks: "axes do not feel what their twigs bear",
			},
		],
	},
	{
		file: "wasm-core/grammars/bunch/grape-bunch-4.lsys",
		suites: [
			"tests/core/models/bunch/living_natural_text_test.cpp",
			"tests/core/models/bunch/grammars_test.cpp",
			`${TESTS}/natural_test.cpp`,
		],
		faults: [
			{
				id: "grammar-4-no-pedicel-aside",
				find: "[ /(vary*(ran(50)-25)) -(alpha_y+vary*(ran(30)-15)) Ap(fine, s) ]",
				replace: "",
				breaks: "twigs end in two flowers in place of three",
			},
		],
	},
];
