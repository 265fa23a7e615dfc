/** Leaf, tree and root: the system of particles that they share. */
const SRC = "wasm-core/src/models/particles";
const TESTS = "tests/core/models/particles";

export default [
	{
		file: `${SRC}/crowd.cpp`,
		suites: [`${TESTS}/crowd_test.cpp`],
		faults: [
			{
				id: "crowd-energy-lost-in-meeting",
				find: "energies_[heavy] += energies_[light];",
				replace: "",
				breaks: "energy is lost wherever two meet",
			},
			{
				id: "crowd-light-goes-on",
				find: "const bool second = energies_[pair.b] > energies_[pair.a];",
				replace: "const bool second = energies_[pair.b] < energies_[pair.a];",
				breaks: "the lighter of two goes on, and trails jump to it",
			},
			{
				id: "crowd-joins-its-own",
				find: "|| heir(node.particle) == self ||",
				replace: "||",
				breaks: "a particle ends in its own trail, and its energy never arrives",
				hangs: true,
			},
			{
				id: "crowd-joined-at-home-lost",
				find: "arrived_ += energies_[slot];\n    else",
				replace: "arrived_ += 0;\n    else",
				breaks: "energy that joins a trail already home is lost",
			},
			{
				id: "crowd-without-patience",
				find: "const bool alone = steps_ > patience_ || count < 2;",
				replace: "const bool alone = count < 2;",
				breaks: "bends hold two in a circle for ever",
			},
			{
				id: "crowd-out-of-the-shape",
				find: "if (guide_->passes(place, place + rules_.step * sum)) {",
				replace: "if (true) {",
				breaks: "trails leave the outline",
			},
			{
				id: "crowd-printed-rule-damped",
				find: "rules_.printed ? towards(glm::vec3(0), aside + ahead)",
				replace: "rules_.printed ? (aside + ahead) * 0.5f",
				breaks: "the printed rule is not the printed one",
			},
		],
	},
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
		suites: [`${TESTS}/trunk_test.cpp`, `${TESTS}/tree_test.cpp`],
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
		file: `${SRC}/trail_plant.cpp`,
		suites: [`${TESTS}/trail_plant_test.cpp`],
		faults: [
			{
				id: "trails-as-thin-as-the-lightest",
				find: "most = std::max(most, trails.energy[i]);",
				replace: "most = most > 0 ? std::min(most, trails.energy[i]) : trails.energy[i];",
				breaks: "branches are pinched at every fork",
			},
			{
				id: "trails-square-root-is-linear",
				find: "? std::sqrt(share)",
				replace: "? share",
				breaks: "Leonardo's rule does not hold",
			},
		],
	},
	{
		file: `${SRC}/moment.cpp`,
		suites: [`${TESTS}/moment_test.cpp`],
		faults: [
			{
				id: "moment-piece-by-piece",
				find: "(moment - left) / (there - left)) * way",
				replace: "0.0f) * way",
				breaks: "particles stand at a place until they jump to the next",
			},
		],
	},
	{
		file: `${SRC}/grown.cpp`,
		suites: [`${TESTS}/tree_life_test.cpp`],
		faults: [
			{
				id: "grown-by-whole-steps",
				find: "habit.age * static_cast<float>(last)",
				replace: "static_cast<float>(static_cast<std::uint32_t>(habit.age * static_cast<float>(last)) / 8 * 8)",
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
				find: "if (guide.open(places[i]) && guide.sees(places[i], places[next])) continue;",
				replace: "continue;",
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
		suites: [`${TESTS}/tree_test.cpp`],
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
		suites: [`${TESTS}/tree_test.cpp`],
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
		file: `${SRC}/dressing.cpp`,
		suites: [`${TESTS}/tree_dress_test.cpp`],
		faults: [
			{
				id: "collars-black",
				find: "  mend_normals(stems.mesh);",
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
		file: `${SRC}/outline.cpp`,
		suites: [`${TESTS}/outline_test.cpp`],
		faults: [
			{
				id: "outline-edges-in-one-cell",
				find: "see(static_cast<std::size_t>(y * across_ + x));",
				replace: "return see(static_cast<std::size_t>(y * across_ + x));",
				breaks: "straight ways go out over edges",
			},
			{
				id: "outline-certain-of-too-much",
				find: "free = std::max(0.0f, free - to_corner * cell_);",
				replace: "free = std::max(0.0f, free + to_corner * cell_);",
				breaks: "what is beside the margin is taken to be free",
			},
			{
				id: "outline-off-the-edge-of-a-cell",
				find: "right = column_of(p.x + reach)",
				replace: "right = column_of(p.x)",
				breaks: "edges on the right are not seen",
			},
		],
	},
	{
		file: `${SRC}/waypoints.cpp`,
		suites: [`${TESTS}/waypoints_test.cpp`],
		faults: [
			{
				id: "waypoints-of-what-was-asked-first",
				find: "while (!open_.empty() && !asked.closed) spread_next();",
				replace: "if (!open_.empty() && !asked.closed) spread_next();",
				breaks: "ways are known only as far as was asked often enough",
			},
		],
	},
	{
		file: `${SRC}/polish.cpp`,
		suites: [`${TESTS}/venation_test.cpp`, `${TESTS}/polish_test.cpp`],
		faults: [
			{
				id: "polish-by-whole-passes",
				find: "std::min(at.passes, 1.0f) * (middle - places[at.place])",
				replace: "1.0f * (middle - places[at.place])",
				breaks: "a little smoothing is as much as a whole pass, and grows by jerks",
			},
			{
				id: "polish-leaves-bumps",
				find: "constexpr float back_from = 2;",
				replace: "constexpr float back_from = 1;",
				breaks: "side veins step aside on their way",
			},
			{
				id: "polish-through-the-margin",
				find: "if (free) trails.places[i] = laid;",
				replace: "trails.places[i] = laid;",
				breaks: "trails are laid back across what is between",
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
		file: `${SRC}/neighbours.cpp`,
		suites: [`${TESTS}/crowd_test.cpp`],
		faults: [
			{
				id: "neighbours-lost-by-rounding",
				find: "1.001f * glm::distance(low, high)",
				replace: "glm::distance(low, high)",
				breaks: "the last two particles of a crowd do not see each other",
			},
		],
	},
	{
		file: `${SRC}/scatter.cpp`,
		suites: [`${TESTS}/scatter_test.cpp`],
		faults: [
			{
				id: "scatter-looks-at-air",
				find: "if (lattice.share_of(cell, length, region) == Share::none) continue;",
				replace: "",
				breaks: "crowns far apart take minutes",
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
		file: `${SRC}/foot.cpp`,
		suites: [`${TESTS}/foot_test.cpp`],
		faults: [
			{
				id: "foot-cut-aslant",
				find: "std::max(positions[3 * v + 1], foot.start.y)",
				replace: "positions[3 * v + 1]",
				breaks: "a swaying trunk is cut aslant below the ground",
			},
		],
	},
];
