/** Leaf, tree and root: how their particles run. */
const SRC = "wasm-core/src/models/particles";
const TESTS = "tests/core/models/particles";

export default [
	{
		file: `${SRC}/particle_system.cpp`,
		suites: [`${TESTS}/particle_system_test.cpp`],
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
				find: "|| union_root(node.particle) == self ||",
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
				id: "crowd-without-step-budget",
				find: "const bool alone = steps_ > step_budget_ || count < 2;",
				replace: "const bool alone = count < 2;",
				breaks: "bends hold two in a circle without end",
			},
			{
				id: "crowd-out-of-the-shape",
				find: "if (guide_->passes(place, place + rules_.step * sum)) {",
				replace: "if (true) {",
				breaks: "trails leave the outline",
			},
			{
				id: "crowd-printed-rule-damped",
				find: "rules_.printed ? direction_to(glm::vec3(0), to_neighbour + ahead)",
				replace: "rules_.printed ? (to_neighbour + ahead) * 0.5f",
				breaks: "the printed rule is not the printed one",
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
				find: "(moment - left_at) / (arrives_at - left_at)) * way",
				replace: "0.0f) * way",
				breaks: "particles stand at a place until they jump to the next",
			},
		],
	},
	{
		file: `${SRC}/outline.cpp`,
		suites: [`${TESTS}/outline_test.cpp`],
		faults: [
			{
				id: "outline-edges-in-one-cell",
				find: "visit(static_cast<std::size_t>(y * across_ + x));",
				replace: "return visit(static_cast<std::size_t>(y * across_ + x));",
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
				find: "if (free) trails.places[i] = moved;",
				replace: "trails.places[i] = moved;",
				breaks: "trails are laid back across what is between",
			},
		],
	},
	{
		file: `${SRC}/neighbours.cpp`,
		suites: [`${TESTS}/particle_system_test.cpp`],
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
		file: "wasm-core/src/models/particles/boundary.cpp",
		suites: ["tests/core/models/particles/boundary_test.cpp", "tests/core/models/tree/tree_test.cpp"],
		faults: [
			{
				id: "particles-own-inner-boundary-ignored",
				find: "if (own.triangles.empty()) return scaled(outer, about, size);",
				replace: "return scaled(outer, about, size);",
				breaks: "the inner boundary is the outer one made smaller, whatever mesh was chosen for it",
			},
		],
	},
	{
		file: "wasm-core/src/models/tree/model.cpp",
		suites: ["tests/core/models/tree/tree_test.cpp"],
		faults: [
			{
				id: "particles-light-all-alike",
				find: "255 * std::clamp(share, 0.0f, 1.0f) + 0.5f",
				replace: "255.0f",
				breaks: "the light shown in a crown is the same everywhere",
			},
		],
	},
];
