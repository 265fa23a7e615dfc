/** Gestures: what a hand says, and which two numbers it drives. */
export default [
	{
		file: "web/src/controls/gestures/hand.ts",
		suites: ["tests/web/controls/gestures/hand.test.ts"],
		faults: [
			{
				id: "gestures-not-mirrored",
				find: "within(1 - mean(({ x }) => x))",
				replace: "within(mean(({ x }) => x))",
				breaks: "the circle goes left where the hand goes right",
			},
			{
				id: "gestures-pinch-goes-on",
				find: "return this.#held && !before;",
				replace: "return this.#held;",
				breaks: "one pinch brings pair after pair",
			},
			{
				id: "gestures-tremble",
				find: "shareIn(passed, REST + HASTE * Math.abs(speed))",
				replace: "1",
				breaks: "a hand at rest makes the flower tremble",
			},
		],
	},
	{
		file: "web/src/controls/gestures/pair.ts",
		suites: ["tests/web/controls/gestures/pair.test.ts"],
		faults: [
			{
				id: "gestures-one-left-out",
				find: "last + 1 < axes.length ? last + 1 : 0",
				replace: "last + 2 < axes.length ? last + 2 : 0",
				breaks: "some numbers never come to the hand",
			},
		],
	},
];
