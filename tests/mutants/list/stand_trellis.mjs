/** Rows of a stand: posts and wires, and plants attached to organs of their parent. */
const SRC = "wasm-core/src/models/stand";
const TESTS = "tests/core/models/stand";
const WEB = "tests/web/models/stand";

export default [
	{
		file: `${SRC}/trellises.cpp`,
		suites: [`${TESTS}/trellises_test.cpp`],
		faults: [
			{
				id: "stand-wires-do-not-follow-the-ground",
				find: "return {at.x, relief_.at(at.x, at.y) + height, at.y};",
				replace: "return {at.x, height, at.y};",
				breaks: "wires hang over hollows and are buried in rises, off the vines that are tied to them",
			},
			{
				id: "stand-posts-at-plants",
				find: "start = first_plant - 0.5f * step;",
				replace: "start = first_plant;",
				breaks: "posts stand in vines",
			},
		],
	},
	{
		file: "web/src/models/stand/hanging.ts",
		suites: [`${WEB}/hanging.test.ts`],
		faults: [
			{
				id: "stand-hung-as-if-unturned",
				find: "return [footX + cosine * x - sine * z, footY + size * y, footZ + sine * x + cosine * z];",
				replace: "return [footX + size * x, footY + size * y, footZ + size * z];",
				breaks: "bunches hang in the air beside vines that run another way",
			},
			{
				id: "stand-left-out-untold",
				find: "if (spots) unplaced += siblings - placed;",
				replace: "if (!spots) unplaced += siblings - placed;",
				breaks: "nobody hears that fewer bunches hang than the plan says",
			},
		],
	},
];
