/** Hand gestures: recognition, and the two parameters that they set. */
export default [
	{
		file: "web/src/grammar_editor/gestures/hand.ts",
		suites: ["tests/web/grammar_editor/gestures/hand.test.ts"],
		faults: [
			{
				id: "gestures-not-mirrored",
				find: "withoutMargin(1 - mean(({ x }) => x))",
				replace: "withoutMargin(mean(({ x }) => x))",
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
				find: "shareIn(elapsed, REST + HASTE * Math.abs(speed))",
				replace: "1",
				breaks: "a hand at rest makes the flower tremble",
			},
		],
	},
	{
		file: "web/src/grammar_editor/gestures/pair.ts",
		suites: ["tests/web/grammar_editor/gestures/pair.test.ts"],
		faults: [
			{
				id: "gestures-one-left-out",
				find: "last + 1 < axes.length ? last + 1 : 0",
				replace: "last + 2 < axes.length ? last + 2 : 0",
				breaks: "some numbers never come to the hand",
			},
		],
	},
	{
		file: "web/src/grammar_editor/gestures/lean.ts",
		suites: ["tests/web/grammar_editor/gestures/lean.test.ts"],
		faults: [
			{
				id: "gestures-bend-in-space",
				find: "right < 0 ? 1 - share : share",
				replace: "share",
				breaks: "a flower seen from behind bends away from the circle",
			},
		],
	},
	{
		file: "web/src/render/camera_controller.ts",
		suites: ["tests/web/render/camera_controller.test.ts"],
		faults: [
			{
				id: "gestures-out-of-the-picture",
				find: "if (this.#profile && !showsWhole(shown, this.#profile, lens))",
				replace: "if (now.distance > 1.12 * shown.distance)",
				breaks: "a flower that bends aside leaves the picture",
			},
			{
				id: "gestures-view-comes-nearer",
				find: "distance: Math.max(now.distance, shown.distance)",
				replace: "distance: now.distance",
				breaks: "the view comes nearer to a flower that bends aside, under the hand",
			},
		],
	},
	{
		file: "wasm-core/grammars/flower/bluebell.gl3",
		suites: ["tests/web/models/flower/lean.test.ts"],
		faults: [
			{
				id: "flower-bends-elsewhere",
				find: "bend*sin(-85)",
				replace: "bend*sin(85)",
				breaks: "a bluebell bends away from the circle, for its stem is rolled",
			},
		],
	},
];
