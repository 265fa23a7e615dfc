/** Any text as a plant. */
const CORE = "wasm-core/src";
const WEB = "web/src";
const TESTS = "tests/core";

export default [
	{
		file: `${CORE}/geometry/polygon.cpp`,
		suites: [`${TESTS}/geometry/polygon_test.cpp`],
		faults: [
			{
				id: "polygon-lines-are-triangles",
				find: "if (!(glm::length(twice) > flat * longest)) return;",
				replace: "",
				breaks: "a corner on a line between its neighbours is a triangle",
			},
			{
				id: "polygon-every-corner-an-ear",
				find: "looks_ > most_looks || is_ear(at)",
				replace: "true || is_ear(at)",
				breaks: "triangles lie outside of what they fill",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/girth.cpp`,
		suites: [`${TESTS}/models/grammar/grammar_model_test.cpp`],
		faults: [
			{
				id: "girth-said-widths-as-they-are",
				find: "segment.radius *= girth.said;",
				replace: "",
				breaks: "the factor on a text's widths reaches one end of a line alone",
			},
			{
				id: "girth-tips-not-counted",
				find: "tips[segments[i].parent] += tips[i];",
				replace: "tips[segments[i].parent] = tips[i];",
				breaks: "a trunk is as thin as its last branch",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/sketch.cpp`,
		suites: [`${TESTS}/models/grammar/dressing_test.cpp`, `${TESTS}/models/grammar/grammar_model_test.cpp`],
		faults: [
			{
				id: "sketch-colour-beyond-palette",
				find: "std::clamp<std::int32_t>(turtle.colour, 1, colours)",
				replace: "turtle.colour",
				breaks: "a colour that no palette has is asked for",
			},
			{
				id: "sketch-natural-colour",
				find: "asked == 1 ? natural : asked",
				replace: "asked",
				breaks: "leaves of a text without colours are brown",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/dressing.cpp`,
		suites: [`${TESTS}/models/grammar/dressing_test.cpp`],
		faults: [
			{
				id: "dressing-half-turns",
				find: "if (m[k][k] > m[i][i]) i = k;",
				replace: ";",
				breaks: "what is turned by half a circle stands askew",
			},
		],
	},
	{
		file: `${WEB}/models/grammar/details/constants.ts`,
		suites: ["tests/web/models/grammar/document.test.ts"],
		faults: [
			{
				id: "constants-unsorted",
				find: "[...found].sort(([a], [b]) => (a < b ? -1 : 1))",
				replace: "[...found]",
				breaks: "the same constants in another order are another document",
			},
		],
	},
	{
		file: `${WEB}/models/for_text.ts`,
		suites: ["tests/web/models/grammar/document.test.ts"],
		faults: [
			{
				id: "for-text-first-model",
				find: "if (model.details.some(({ claims }) => claims?.(text))) return model;",
				replace: "return model;",
				breaks: "every dropped text is a bunch's",
			},
		],
	},
];
