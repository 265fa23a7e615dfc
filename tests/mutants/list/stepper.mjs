/** Derivations step by step: parsing, highlights, picking. */
const SRC = "web/src/grammar_editor";
const TESTS = "tests/web/grammar_editor";

export default [
	{
		file: `${SRC}/trace_reader.ts`,
		suites: [`${TESTS}/trace_reader.test.ts`],
		faults: [
			{
				id: "stepper-string-of-another-step",
				find: "if (this.#page && this.#page.step !== this.step) this.#page = undefined;",
				replace: "",
				breaks: "a slider dragged fast shows the string of a step that it has left",
			},
			{
				id: "stepper-late-answer-of-another-document",
				find: "if (this.#requestTrace !== requestTrace) {",
				replace: "if (false) {",
				breaks: "the string of a text that is no more comes in place of the present one's",
			},
			{
				id: "stepper-long-question-goes-on",
				find: "running.ending.abort();\n\t\t\tthis.#running = undefined;\n\t\t\tthis.#update();",
				replace: "",
				breaks: "a step that takes seconds has to be waited for though nobody wants it any more",
			},
			{
				id: "stepper-wanted-question-ends",
				find: "this.#resume(this.#running);",
				replace: "this.#abandon(this.#running);",
				breaks: "a step that is left and come back to is asked for from the beginning",
			},
			{
				id: "stepper-superseded-is-a-fault",
				find: "const again = error instanceof Superseded;",
				replace: "const again = false;",
				breaks: "a click in the view puts an error in the string's place",
			},
		],
	},
	{
		file: `${SRC}/derivation.ts`,
		suites: [`${TESTS}/derivation.test.ts`],
		faults: [
			{
				id: "stepper-plant-of-a-step-left",
				find: "this.step !== step || !this.follows) return;",
				replace: "!this.follows) return;",
				breaks: "the view shows the plant of a step that has been left",
			},
			{
				id: "stepper-descends-to-the-wrong-child",
				find: "this.go(this.step + 1, children.first);",
				replace: "this.go(this.step + 1, this.#chosen);",
				breaks: "Down leads to a module that is no child",
			},
			{
				id: "stepper-grows-without-end",
				find: "this.#ungrown = { from, step };",
				replace: "",
				breaks: "a step whose plant cannot be drawn is grown again and again",
			},
			{
				id: "stepper-module-of-another-step",
				find: "if (!page || step !== this.last) return undefined;",
				replace: "if (!page) return undefined;",
				breaks: "what is met in the view while the next step grows marks a foreign module",
			},
		],
	},
	{
		file: `${SRC}/lit_parts.ts`,
		suites: [`${TESTS}/trace_words.test.ts`, `${TESTS}/derivation.test.ts`],
		faults: [
			{
				id: "stepper-peduncle-lit",
				find: "return module === NOT_DRAWN ? undefined : module;",
				replace: "return module;",
				suites: [`${TESTS}/trace_words.test.ts`],
				breaks: "a click on what the text has not drawn leads beyond the string",
			},
			{
				id: "stepper-itself-lit-in-the-last-plant",
				find: "scene?.step === counts.length - 1 ? module.last : undefined",
				replace: "scene?.step === counts.length - 1 ? { first: index, count: 1 } : undefined",
				suites: [`${TESTS}/derivation.test.ts`],
				breaks: "a module of an early step lights a foreign segment of the last plant",
			},
		],
	},
	{
		file: "web/src/plant/sighting.ts",
		suites: ["tests/web/plant/sighting.test.ts"],
		faults: [
			{
				id: "stepper-threads-out-of-reach",
				find: "missed <= radius + slack * at",
				replace: "missed <= radius",
				breaks: "no click hits a line that is drawn a pixel wide",
			},
			{
				id: "stepper-ball-in-its-own-size",
				find: "Math.abs(transform[7]) * ball.radius",
				replace: "0.3 * ball.radius",
				breaks: "a click at the tip of a large leaf goes through it",
			},
		],
	},
	{
		file: "web/src/app/solid_view.ts",
		suites: ["tests/web/app/solid_view.test.ts"],
		faults: [
			{
				id: "stepper-picture-of-a-step",
				find: "const instead = this.#picturesInProgress > 0 ? undefined : this.#instead;",
				replace: "const instead = this.#instead;",
				breaks: "a saved picture carries the link of another plant than it shows",
			},
		],
	},
];
