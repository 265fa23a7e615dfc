/** The bunch in the core: the paper's procedure and the parts common to both procedures. */
const SRC = "wasm-core/src/models/bunch";
const TESTS = "tests/core/models/bunch";

export default [
	{
		file: `${SRC}/paper/growth.cpp`,
		suites: [`${TESTS}/paper/growth_test.cpp`, `${TESTS}/bunch_test.cpp`],
		faults: [
			{
				id: "growth-parents-tip-is-in-the-way",
				find: "newborn.parent = tips_[parent];",
				replace: ";",
				breaks: "internodes turn away from the one that bears them",
			},
			{
				id: "growth-withered-keep-their-length",
				find: "parameters[question.slots.length] = constants_.withered_length;",
				replace: "",
				breaks: "withered pedicels are as long as those that bear",
			},
			{
				id: "growth-cut-rachis-unsaid",
				find: "rachis_cut |= rachis;",
				replace: "",
				breaks: "nothing says that the rachis ends early",
			},
			{
				id: "growth-laid-rachis-forgotten",
				find: "room = reserved->room;",
				replace: "room = {};",
				breaks: "a wing's rachis is cut off",
			},
		],
	},
	{
		file: `${SRC}/paper/interaction.cpp`,
		suites: [`${TESTS}/paper/interaction_test.cpp`],
		faults: [
			{
				id: "interaction-never-stops-at-delta",
				find: "if (!newborn_.pedicel && turned >= options_.delta) return room(false, last, adjustments, turned);",
				replace: "",
				breaks: "internodes bend as far as pedicels may",
			},
			{
				id: "interaction-sag-past-vertical",
				find: "std::min(options_.sag, upright)",
				replace: "options_.sag",
				breaks: "pedicels swing past straight down",
			},
			{
				id: "interaction-turns-the-wrong-way",
				find: "const float right = -glm::dot(heading, turtle_.left);",
				replace: "const float right = glm::dot(heading, turtle_.left);",
				breaks: "what asks for room is turned into what is in the way",
			},
			{
				id: "interaction-sags-into-others",
				find: "probe(lower.sphere).contacts == 0 ? lower : free;",
				replace: "lower;",
				breaks: "sagging berries overlap",
			},
		],
	},
	{
		file: `${SRC}/paper/paper.cpp`,
		suites: [`${TESTS}/model_test.cpp`],
		faults: [
			{
				id: "paper-stems-unscaled",
				find: "for (Internode& internode : internodes) scale(internode, metres);",
				replace: "",
				breaks: "stems are hundreds of times too large",
			},
			{
				id: "paper-scale-ignored",
				find: "values[unit] * metres_per_millimetre;",
				replace: "metres_per_millimetre;",
				breaks: "the slider of the scale does nothing",
			},
		],
	},
	{
		file: `${SRC}/berry_ids.cpp`,
		suites: [`${TESTS}/berry_ids_test.cpp`],
		faults: [
			{
				id: "berry-ids-of-the-wing-clash",
				find: "i < second_from ? addresses[i] : hash_combine(addresses[i], 2)",
				replace: "addresses[i]",
				breaks: "thinning a berry of the wing may take one of the bunch",
			},
			{
				id: "berry-ids-given-twice",
				find: "while (!used_ids.insert(id_of(address)))",
				replace: "if (!used_ids.insert(id_of(address)) && false)",
				breaks: "two berries share an id",
			},
		],
	},
	{
		file: `${SRC}/plan.cpp`,
		suites: [`${TESTS}/plan_test.cpp`],
		faults: [
			{
				id: "plan-rounds-down",
				find: "static_cast<std::int32_t>(x + 0.5f)",
				replace: "static_cast<std::int32_t>(x)",
				breaks: "bunches of the paper have fewer axes than Table 3 says",
			},
			{
				id: "plan-fit-is-all-or-nothing",
				find: "1 + (target - 1) * amount",
				replace: "target",
				breaks: "fit 0 follows the handles too",
			},
		],
	},
	{
		file: `${SRC}/paper/skeleton_drawing.cpp`,
		suites: [`${TESTS}/skeleton_drawing_test.cpp`, `${TESTS}/bunch_test.cpp`],
		faults: [
			{
				id: "skeleton-axes-off-by-one",
				find: "first_axis_ + parent.rachis_depth - 1",
				replace: "first_axis_ + parent.rachis_depth",
				breaks: "axes are numbered from 1",
			},
			{
				id: "skeleton-thorns-are-pedicels",
				find: "part.kind = Kind::axis;",
				replace: "",
				breaks: "a thorn beside a berry counts as a pedicel",
			},
		],
	},
	{
		file: `${SRC}/roles.cpp`,
		suites: [`${TESTS}/roles_test.cpp`],
		faults: [
			{ id: "roles-declared-unheeded", find: "kinds[symbol] = *kind;", replace: "", breaks: "#role says nothing" },
		],
	},
	{
		file: `${SRC}/paper/envelope.cpp`,
		suites: [`${TESTS}/natural/natural_plan_test.cpp`],
		faults: [
			{
				id: "envelope-volume-fourfold",
				find: "return pi / 4 * (right + left)",
				replace: "return pi * (right + left)",
				breaks: "bunches ask for four times their berries",
			},
			{
				id: "envelope-no-rounded-tip",
				find: "if (into <= 0 || side.rounding <= 0) return side.narrow;",
				replace: "return side.narrow;",
				breaks: "bunches end like a barrel",
			},
		],
	},
	{
		file: `${SRC}/model.cpp`,
		suites: [`${TESTS}/model_test.cpp`],
		faults: [
			{
				id: "model-sides-read-from-segments",
				find: 'blocks.word("stem_sides")',
				replace: 'blocks.word("berry_segments")',
				breaks: "stems have as many sides as berries have segments",
			},
			{
				id: "model-thinned-ids-as-reasons",
				find: "*at = static_cast<std::uint32_t>(one.why);",
				replace: "*at = one.id;",
				breaks: "what is not there gives nonsense as its reason",
			},
			{
				id: "model-drop-is-width",
				find: "at[1] = side.point.drop;",
				replace: "at[1] = side.point.width;",
				breaks: "files say that every side drops as far as it is wide",
			},
			{
				id: "model-states-lost",
				find: "*at = static_cast<std::uint8_t>(one.state);",
				replace: "*at = 0;",
				breaks: "nothing is withered in view and files",
			},
		],
	},
	{
		file: `${SRC}/bunch.cpp`,
		suites: [`${TESTS}/model_test.cpp`],
		faults: [
			{
				id: "bunch-fingerprint-without-radius",
				find: "    print.add(berry.radius);\n",
				replace: "",
				breaks: "two bunches of unlike berries have one fingerprint",
			},
			{
				id: "bunch-joints-counted",
				find: "if (internode.joint) continue;",
				replace: "",
				breaks: "a pedicel in two pieces counts twice",
			},
			{
				id: "bunch-stem-sides-unheeded",
				find: "if (request.stem_sides) tubes.sides = std::clamp(request.stem_sides, 3u, 64u);",
				replace: "",
				breaks: "stems have the sides that the core likes, whatever was asked for",
			},
		],
	},
];
