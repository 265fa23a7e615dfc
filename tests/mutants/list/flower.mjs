/** Flowers: the language, and what grows from it. */
const SRC = "wasm-core/src/models/flower";
const TESTS = "tests/core/models/flower";
const DERIVATION = [`${TESTS}/derivation_test.cpp`];
const WEB = ["tests/web/models/flower/grown.test.ts"];

export default [
	{
		file: `${SRC}/derivation.cpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-first-listed-wins",
				find: "same->growth = growth.number;",
				replace: ";",
				breaks: "of two productions on one face the first wins, and Table 3 has no receptacle",
			},
			{
				id: "flower-modules-grow-together",
				find: "[&](std::uint32_t other) { return instance_of(other) == instance_; }",
				replace: "[](std::uint32_t) { return true; }",
				breaks: "petals of a kind are glued to each other",
			},
			{
				id: "flower-glue-gives-up",
				find: "waits |= !here;",
				replace: "waits = false;",
				breaks: "faces that are not adjacent at once are never glued",
			},
		],
	},
	{
		file: `${SRC}/numbers.cpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-nothing-is-inherited",
				find: "if (record.inherits) {",
				replace: "if (false) {",
				breaks: "what a list leaves empty is the definition's even where the predecessor has the same name",
			},
			{
				id: "flower-one-luck-for-all",
				find: "evaluation_.describe(growth.arguments, record.address, values);",
				replace: "evaluation_.describe(growth.arguments, 1, values);",
				breaks: "all volumes of a production draw the same number",
			},
		],
	},
	{
		file: `${SRC}/evaluation.cpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-calls-give-nothing",
				find: "if (said != given.end()) {",
				replace: "if (false) {",
				breaks: "a module's variables keep their own values whatever a call gives them",
			},
		],
	},
	{
		file: `${SRC}/reader.cpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-given-and-not-rebuilt",
				find: "if (program_.variables[variable].rebuilds) rebuilds(uses);",
				replace: ";",
				breaks: "what a call gives to a variable that the map depends on only places it anew",
			},
			{
				id: "flower-eight-numbers-with-translation",
				find: "const bool translated = entries.size() == 9",
				replace: "const bool translated = entries.size() >= 8",
				breaks: "eight numbers are read as nine",
			},
		],
	},
	{
		file: "wasm-core/src/generalized_map/boundary.cpp",
		suites: WEB,
		faults: [
			{
				id: "flower-inside-out",
				find: "for (std::uint8_t& kind : kinds) kind = kind == 1;",
				replace: "for (std::uint8_t& kind : kinds) kind = kind == 2;",
				breaks: "the skin faces inwards",
			},
		],
	},
];
