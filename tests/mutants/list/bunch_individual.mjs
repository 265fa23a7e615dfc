/** Individual features of natural bunches: the seed's outline, the wing, the peduncle. */
const SRC = "wasm-core/src/models/bunch/natural";
const TESTS = "tests/core/models/bunch/natural";

export default [
	{
		file: `${SRC}/individual.cpp`,
		suites: [`${TESTS}/individual_test.cpp`],
		faults: [
			{
				id: "individual-seed-1-anywhere",
				find: "(seed - 1) * strides[which]",
				replace: "seed * strides[which]",
				breaks: "the page opens with a bunch that does not fill its handles",
			},
			{
				id: "individual-lots-that-go-together",
				find: "0x9159015a3070dd17u",
				replace: "0x3c6ef372fe94f82bu",
				breaks: "how long a seed's bunch is settles how wide its left side is",
			},
			{
				id: "individual-counted-as-any",
				find: "counted ? 1 / longer : ",
				replace: "",
				breaks: "bunches thinned to a count have room for others",
			},
			{
				id: "individual-racemes-branch",
				find: "std::min(width, side.width)",
				replace: "width",
				breaks: "a currant's seed may bear branches",
			},
			{
				id: "individual-no-gaps",
				find: "fill += height_ *",
				replace: "fill += 0 *",
				breaks: "every bunch is filled evenly",
			},
		],
	},
	{
		file: `${SRC}/wing.cpp`,
		suites: [`${TESTS}/wing_test.cpp`],
		faults: [
			{
				id: "wing-stalk-stiff",
				find: "stalk.angle / (1 + stalk.load / half_load)",
				replace: "stalk.angle",
				breaks: "a wing stands out like a bough, however heavy",
			},
			{
				id: "wing-in-the-bunch",
				find: "beside * largest_half_width(bunch, stalk.side, upper_part) + ",
				replace: "",
				breaks: "a wing hangs within the first bunch",
			},
			{
				id: "wing-always-left",
				find: "stalk.side, stalk_point(stalk, lean, length, 1)};",
				replace: "1, stalk_point(stalk, lean, length, 1)};",
				breaks: "wings put elsewhere lean to the left",
			},
		],
	},
	{
		file: `${SRC}/peduncle.cpp`,
		suites: [`${TESTS}/peduncle_test.cpp`],
		faults: [
			{
				id: "peduncle-of-everything",
				find: "if (children[i] != 1) break;",
				replace: "if (children[i] == 0) break;",
				breaks: "the peduncle goes on down the rachis",
			},
			{
				id: "peduncle-above-all-of-it",
				find: "length - length_to_first_branch(internodes)",
				replace: "length",
				breaks: "peduncles are longer than asked for",
			},
			{
				id: "peduncle-without-a-node",
				find: "{node, 1.6f}",
				replace: "{node, 1.26f}",
				breaks: "the peduncle is a plain stick",
			},
		],
	},
];
