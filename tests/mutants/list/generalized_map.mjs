/** Generalized maps: how volumes hang together, and where they are. */
const SRC = "wasm-core/src/generalized_map";
const TESTS = "tests/core/generalized_map";

export default [
	{
		file: `${SRC}/map.cpp`,
		suites: [`${TESTS}/map_test.cpp`],
		faults: [
			{
				id: "map-grown-inside-out",
				find: "face == base_face ? alpha_[0][support] : support",
				replace: "support",
				breaks: "what grows on a base is the wrong way round, and inside and outside are one",
			},
			{
				id: "map-attached-unseen",
				find: "if (list_[child].parent_face == face) return false;",
				replace: "",
				breaks: "a module stands on the same face again at every step",
			},
			{
				id: "map-sewn-half",
				find: "    b = alpha_[0][b];\n    sew(3, a, b);",
				replace: "    b = alpha_[0][b];",
				breaks: "faces hang together at one end of each edge",
			},
			{
				id: "map-glued-though-unequal",
				find: "if (degree(d) != degree(hinge)) return Refusal::unequal;",
				replace: "",
				breaks: "a hexagon is glued to a square",
			},
			{
				id: "map-gap-not-crossed",
				find: "while (alpha_[3][d] != d) d = alpha_[2][alpha_[3][d]];",
				replace: "if (alpha_[3][d] != d) d = alpha_[2][alpha_[3][d]];",
				breaks: "lobes with more than one volume between them are never glued",
				hangs: true,
			},
		],
	},
	{
		file: `${SRC}/split.cpp`,
		suites: [`${TESTS}/split_test.cpp`, `${TESTS}/random_test.cpp`],
		faults: [
			{
				id: "split-neighbours-left",
				find: "    if (w != none) {",
				replace: "    if (false) {",
				breaks: "a split tears its neighbours' faces",
			},
			{
				id: "split-each-for-itself",
				find: "if (!is_of_step(a(0, edge), step)) cut_edge(edge, step);",
				replace: "cut_edge(edge, step);",
				breaks: "neighbours that are split together are cut at different heights",
			},
			{
				id: "split-cut-nowhere",
				find: "return next == other || map_.face_[a(2, next)] == map_.face_[dart];",
				replace: "return true;",
				breaks: "a volume that is split from both sides is cut once, and nothing lies between",
			},
			{
				id: "split-uneven-all-the-same",
				find: "return a(2, leaving(d)) == a(1, a(2, a(1, d)));",
				replace: "return d != none;",
				breaks: "a face with a corner in the middle of an edge is split into a heap of darts",
				hangs: true,
			},
			{
				id: "split-folded-all-the-same",
				find: "if (is_of_rim(at) || is_of_rim(a(0, at))) return true;",
				replace: "if (at == none) return true;",
				breaks: "a face that is glued to its own sides is cut through",
				hangs: true,
			},
			{
				id: "split-corners-left-behind",
				find: "if (at(a(2, d)) == f) return a(2, across(a(1, a(0, a(1, d)))));",
				replace: "",
				breaks: "what is left of a split volume has corners that are not its own",
			},
			{
				id: "split-children-left-behind",
				find: "child.parent = part;",
				replace: "",
				breaks: "what has grown on the part is turned as if it stood on the rest",
			},
		],
	},
	{
		file: `${SRC}/check.cpp`,
		suites: [`${TESTS}/check_test.cpp`],
		faults: [
			{
				id: "check-without-products",
				find: "wrong |= (m.a0[a2] ^ m.a2[a0]) | (m.a0[a3] ^ m.a3[a0]) | (m.a1[a3] ^ m.a3[a1]);",
				replace: "",
				breaks: "edges that are sewn at one end alone pass for whole",
			},
			{
				id: "check-without-cells",
				find: "counted[v].vertices != volume.vertices || counted[v].faces != volume.faces ||",
				replace: "",
				breaks: "volumes with a corner too many pass for prisms",
			},
			{
				id: "check-without-folds",
				find: "wrong |= static_cast<std::uint32_t>((a3 != d) & (m.volume[a3] == v));",
				replace: "",
				breaks: "a volume that is sewn to itself passes",
			},
		],
	},
	{
		file: `${SRC}/embedding.cpp`,
		suites: [`${TESTS}/embedding_test.cpp`],
		faults: [
			{
				id: "embedding-last-proposal-wins",
				find: "    places_[vertex] /= static_cast<float>(proposals_[vertex]);\n",
				replace: "",
				breaks: "where lobes are glued the petal bulges to twice its distance",
			},
			{
				id: "embedding-cuts-at-the-origin",
				find: "if (!is_proposed(cuts_[cut].vertex)) places_[cuts_[cut].vertex] = settled_[cut];",
				replace: "continue;",
				breaks: "cut vertices lie at the origin",
			},
			{
				id: "embedding-waits-for-nobody",
				find: "if (cut_of_.empty() || cut_of_[vertex] == none) continue;",
				replace: "",
				breaks: "what stands on a face that was split twice crashes the core",
			},
			{
				id: "embedding-forgotten-corners",
				find: "for (const Placement& placement : placements_) propose_rest(placement, shapes[placement.volume]);",
				replace: "",
				breaks: "corners that are in nobody's end lie at the origin",
			},
			{
				id: "embedding-attached-at-the-origin",
				find: "supports_.push_back(vertex_of_[d]);",
				replace: "supports_.push_back(vertex_of_[0]);",
				breaks: "modules stand at the foot of the plant",
			},
		],
	},
	{
		file: `${SRC}/frame.cpp`,
		suites: [`${TESTS}/embedding_test.cpp`],
		faults: [
			{
				id: "frame-sides-turned",
				find: "static_cast<float>(side_number(face) - 1) * step",
				replace: "static_cast<float>(side_number(face)) * step",
				breaks: "organs grow out of one side towards the next",
			},
			{
				id: "frame-turns-swapped",
				find: "  rotate_pair(own.y, own.z, shape.turn_x);\n  rotate_pair(own.z, own.x, shape.turn_y);",
				replace: "  rotate_pair(own.z, own.x, shape.turn_y);\n  rotate_pair(own.y, own.z, shape.turn_x);",
				breaks: "a petal that is bent and fanned leans elsewhere",
			},
		],
	},
];
