/** Tree and root: the trails of their particles. */
const SRC = "wasm-core/src/models/particles";
const TESTS = "tests/core/models/particles";

export default [
	{
		file: `${SRC}/wood.cpp`,
		suites: [`${TESTS}/wood_test.cpp`],
		faults: [
			{
				id: "wood-to-targets-out-of-reach",
				find: " || !guides[i].reaches(p)) continue;",
				replace: ") continue;",
				breaks: "particles beside a walled trunk run through its walls",
			},
			{
				id: "wood-led-ones-untold",
				find: "wood.tally.stragglers += crowd.stragglers();",
				replace: "",
				breaks: "nothing says that particles had to be led to their target",
			},
		],
	},
	{
		file: `${SRC}/trunk.cpp`,
		suites: [`${TESTS}/trunk_test.cpp`, "tests/core/models/tree/tree_test.cpp"],
		faults: [
			{
				id: "trunk-through-the-top",
				find: "|| outer_->contains(to)",
				replace: "|| true",
				breaks: "trails of weeping branches run over the top of the crown",
			},
		],
	},
	{
		file: `${SRC}/grown.cpp`,
		suites: ["tests/core/models/tree/tree_life_test.cpp"],
		faults: [
			{
				id: "grown-by-whole-steps",
				find: "habit.age * static_cast<float>(steps + further)",
				replace:
					"static_cast<float>(static_cast<std::uint32_t>(habit.age * static_cast<float>(steps + further)) / 8 * 8)",
				breaks: "the tree runs by jerks and is not whole in the end",
			},
		],
	},
	{
		file: `${SRC}/forks.cpp`,
		suites: [`${TESTS}/forks_test.cpp`],
		faults: [
			{
				id: "forks-wide",
				find: "constexpr float cost = 0.95f;",
				replace: "constexpr float cost = 0.3f;",
				breaks: "branches stand nearly at right angles to what bears them",
			},
			{
				id: "forks-into-obstacles",
				find: "take_back_hidden(trails, before, guide);",
				replace: "(void)guide;",
				breaks: "a branch is drawn through a wall",
			},
			{
				id: "forks-past-each-other",
				find: "const float share = most / std::max(glm::length(drawn), most);",
				replace: "const float share = 1;",
				breaks: "two places that draw towards each other change sides",
			},
		],
	},
	{
		file: `${SRC}/axis.cpp`,
		suites: [`${TESTS}/axis_test.cpp`],
		faults: [
			{
				id: "axis-cut-short",
				find: "return straight + at(straight.y) - chord;",
				replace: "return straight;",
				breaks: "particles run beside a trunk that sways, and it has several lines of wood",
			},
		],
	},
	{
		file: `${SRC}/obstacles.cpp`,
		suites: ["tests/core/models/tree/tree_test.cpp"],
		faults: [
			{
				id: "round-obstacles-let-through",
				find: "return glm::dot(nearest, nearest) < 1;",
				replace: "return false;",
				breaks: "branches grow through another tree's crown",
			},
		],
	},
	{
		file: `${SRC}/crown_light.cpp`,
		suites: ["tests/core/models/tree/tree_test.cpp"],
		faults: [
			{
				id: "others-take-no-light",
				find: "const auto within = [&](const Box& other) { return within_round(other, p); };",
				replace: "const auto within = [&](const Box&) { return false; };",
				breaks: "another tree's crown casts no shade",
			},
			{
				id: "walls-take-no-light",
				find: "return opaque / edge;",
				replace: "return 0.0f;",
				suites: [`${TESTS}/obstacles_test.cpp`],
				breaks: "a wall casts no shade",
			},
		],
	},
	{
		file: "wasm-core/src/stems/wood.cpp",
		suites: ["tests/core/models/tree/tree_dress_test.cpp"],
		faults: [
			{
				id: "collars-black",
				find: "  repair_normals(stems.mesh);",
				replace: "",
				breaks: "facets where branches begin are black",
			},
			{
				id: "twigs-as-dear-as-limbs",
				find: "fine_of_all = 0.002f",
				replace: "fine_of_all = 0",
				breaks: "files are four times as large as what is seen of the wood",
			},
		],
	},
	{
		file: `${SRC}/waypoints.cpp`,
		suites: [`${TESTS}/waypoints_test.cpp`],
		faults: [
			{
				id: "waypoints-of-what-was-asked-first",
				find: "while (!open_.empty() && !requested.closed) spread_next();",
				replace: "if (!open_.empty() && !requested.closed) spread_next();",
				breaks: "ways are known only as far as was asked often enough",
			},
		],
	},
	{
		file: `${SRC}/gather.cpp`,
		suites: [`${TESTS}/trunk_test.cpp`, `${TESTS}/obstacles_test.cpp`],
		faults: [
			{
				id: "gather-through-obstacles",
				find: " && guide.sees(trails.places[line[end - 1]], trails.places[line[end]])",
				replace: "",
				breaks: "a trunk runs straight through what stands on its axis",
			},
		],
	},
	{
		file: `${SRC}/twig_shape.cpp`,
		suites: [`${TESTS}/twig_shape_test.cpp`],
		faults: [
			{
				id: "twig-hangs-at-once",
				find: " * smooth_step(0, arc, run[i])",
				replace: "",
				breaks: "hanging twigs break off at the branch that bears them",
			},
			{
				id: "twig-hangs-out",
				find: "if (last && !fits",
				replace: "if (false && !fits",
				breaks: "tips sink out of the boundary",
			},
		],
	},
	{
		file: "wasm-core/src/stems/root_flare.cpp",
		suites: ["tests/core/stems/root_flare_test.cpp"],
		faults: [
			{
				id: "flare-twice-as-wide",
				find: "scale_ *= widening / (mean_width() - 1);",
				replace: "scale_ *= 1;",
				breaks: "trunks are more than twice as wide at the ground as above",
			},
			{
				id: "flare-ends-at-the-ground",
				find: "const glm::vec3 sunk(0, -below * foot_.flare.depth, 0);",
				replace: "const glm::vec3 sunk(0, 0 * below, 0);",
				breaks: "on a slope there is a gap below the trunk",
			},
		],
	},
	{
		file: "wasm-core/src/stems/collar.cpp",
		suites: ["tests/core/stems/collar_test.cpp"],
		faults: [
			{
				id: "collar-off-its-parent",
				find: "edge.away * (edge.value + sunk * parent.radius());",
				replace: "edge.away * 0.0f;",
				breaks: "collars hang over the parent's surface",
			},
		],
	},
];
