/** Animations of growth, and the command line. */
export default [
	{
		file: "web/src/ui/life_player.ts",
		suites: ["tests/web/ui/life_player.test.ts"],
		faults: [
			{
				id: "life-jumps-after-a-nap",
				find: "Math.min(passed, LONGEST_FRAME)",
				replace: "passed",
				breaks: "a page that was hidden jumps to the end of the play",
			},
			{
				id: "life-runs-twice",
				find: "if (this.#isFrameDue) return;",
				replace: "",
				breaks: "a play that is stopped and started quickly runs at twice its speed",
			},
			{
				id: "life-motion-unwelcome-unheeded",
				find: "if (this.#clock.stepwise()) {",
				replace: "if (false) {",
				breaks: "the bunch moves for those who asked for no motion",
			},
			{
				id: "life-of-an-open-flower-only-wilts",
				find: "age >= end || age === bestAge ?",
				replace: "age >= end ?",
				breaks: "a flower that stands open is played from there, and never seen to open",
				suites: ["tests/web/models/flower/age.test.ts"],
			},
			{
				id: "life-fights-the-hand",
				find: "if (this.#lastFrameSpecimen && context.state.specimen !== this.#lastFrameSpecimen) {",
				replace: "if (false) {",
				breaks: "a play overrides the hand on a slider",
			},
			{
				id: "life-a-step-a-frame",
				find: "context.edit({ parameters: { [this.#life.parameter]: age } }, PLAY);",
				replace: "context.set({ parameters: { [this.#life.parameter]: age } });",
				breaks: "a play leaves hundreds of undo steps",
			},
		],
	},
	{
		file: "web/src/ui/life.ts",
		suites: ["tests/web/ui/life.test.ts"],
		faults: [
			{
				id: "life-stage-too-late",
				find: "stages.findLast(({ at, from = at }) => from <= age)",
				replace: "stages.findLast(({ at }) => at <= age)",
				breaks: "a bunch that ripens is still called green",
			},
		],
	},
	{
		file: "web/src/cli/run.ts",
		suites: ["tests/web/cli/run.test.ts", "tests/web/cli/refusals.test.ts"],
		faults: [
			{
				id: "command-line-errors-succeed",
				find: "return error instanceof UsageError || error instanceof FileTooLargeError ? 2 : 1;",
				replace: "return 0;",
				breaks: "a script goes on where nothing was grown",
			},
			{
				id: "command-line-unmeasured",
				find: "json || plantFile(ending)?.form !== undefined || ownFormat(model, ending)?.measured === true,",
				replace: "false,",
				breaks: "files of the command hold no measures",
			},
		],
	},
];
