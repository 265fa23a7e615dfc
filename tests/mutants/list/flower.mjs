/** Flowers in the core: the language and its results. */
const SRC = "wasm-core/src/models/flower";
const TESTS = "tests/core/models/flower";
const DERIVATION = [`${TESTS}/derivation_test.cpp`];
const AGAIN = [`${TESTS}/again_test.cpp`];

export default [
	{
		file: `${SRC}/ranks.hpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-beside-is-along",
				find: "before.beside == 0 && side == 0",
				replace: "before.beside == 0",
				breaks: "what grows on an organ's sides counts as its axis, and rows have no place of their own",
			},
		],
	},
	{
		file: `${SRC}/syntax/program.cpp`,
		suites: [`${TESTS}/limits_test.cpp`],
		faults: [
			{
				id: "flower-follows-another-module",
				find: "std::max(owner[instruction.a], owner[instruction.b])",
				replace: "owner[instruction.b]",
				breaks: "what follows from a module's variables is not worked out anew for each of its instances",
			},
		],
	},
	{
		file: `${SRC}/skin.cpp`,
		suites: AGAIN,
		faults: [
			{
				id: "flower-skin-past-its-limit",
				find: "while (rounds > 1 && free",
				replace: "while (rounds > 9 && free",
				breaks: "a large map's skin has as many triangles as it is asked to have, and takes all memory",
			},
		],
	},
	{
		file: "wasm-core/grammars/flower/meadow.gl3",
		suites: [`${TESTS}/meadow_test.cpp`],
		faults: [
			{
				id: "flower-meadow-in-strips",
				find: "RIGHT : RIGHT_C1 < RIGHT_C3 -> RIGHT_C1 | RIGHT_C3\nLEFT : LEFT_C1 < LEFT_C3 -> LEFT_C1 | LEFT_C3\n\n#module SOW",
				replace: "\n#module SOW",
				breaks: "the ground's rows are not glued to each other",
			},
			{
				id: "flower-meadow-without-clover",
				find: "0.5*flowers*pink",
				replace: "0*flowers*pink",
				breaks: "one of the kinds never grows",
			},
		],
	},
	{
		file: `${SRC}/derivation.cpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-luck-always-rebuilds",
				find: "if (program.draws_rebuild && before.seed != now.seed) return true;",
				replace: "if (before.seed != now.seed) return true;",
				breaks: "every flower of a bed is grown anew",
			},
			{
				id: "flower-luck-never-rebuilds",
				find: "if (program.draws_rebuild && before.seed != now.seed) return true;",
				replace: "",
				breaks: "what is drawn for each instance may change the map, and does not",
			},
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
			{
				id: "flower-never-told-under-other-steps",
				find: "condition_results_[production.number] == 1 && !stopped_ && !cut_short_",
				replace: "condition_results_[production.number] == 1 && !stopped_",
				breaks: "a flower of fewer steps has notes on all that it has not come to",
			},
		],
	},
	{
		file: `${SRC}/syntax/production_reader.cpp`,
		suites: AGAIN,
		faults: [
			{
				id: "flower-blocks-need-all",
				find: "if (of_blocks) uses.add(of_blocks_);",
				replace: "for (std::size_t i = 0; of_blocks && i < program_.variables.size(); ++i) uses.variables.set(i);",
				breaks: "a panicle's length grows it anew, since its branches are counted by a name of a block",
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
				suites: [`${TESTS}/levels_test.cpp`],
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
				find: "if (next_given != given.end() && next_given->first == i) {",
				replace: "if (false) {",
				breaks: "a module's variables keep their own values whatever a call gives them",
			},
		],
	},
	{
		file: `${SRC}/evaluation.cpp`,
		suites: [`${TESTS}/limits_test.cpp`],
		faults: [
			{
				id: "flower-long-conditions-for-nothing",
				find: "  work_ += code.size();",
				replace: "  ++work_;",
				breaks: "a text whose conditions are long keeps the core busy far beyond its limit",
			},
		],
	},
	{
		file: `${SRC}/syntax/production_reader.cpp`,
		suites: DERIVATION,
		faults: [
			{
				id: "flower-given-and-not-rebuilt",
				find: "uses_of_variables_[setting.variable].add(uses);",
				replace: ";",
				breaks: "what a call gives to a variable that the map depends on only places it anew",
			},
		],
	},
	{
		file: `${SRC}/syntax/reader.cpp`,
		suites: DERIVATION,
		faults: [
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
		suites: AGAIN,
		faults: [
			{
				id: "flower-inside-out",
				find: "(d - volume.first) % 2 == (d < end ? 1 : 0)",
				replace: "(d - volume.first) % 2 == (d < end ? 0 : 1)",
				breaks: "the skin faces inwards",
			},
		],
	},
	{
		file: `${SRC}/syntax/reader.cpp`,
		suites: AGAIN,
		faults: [
			{
				id: "flower-orders-place-anew",
				find: "if (of_map) pin_numbers(at_, end);",
				replace: ";",
				breaks: "another order in the text places the old map",
			},
			{
				id: "flower-calls-place-anew",
				find: "if (program_.variables[variable].rebuilds) pin_numbers(statement.begin, statement.end);",
				replace: ";",
				breaks: "what a call gives a variable that orders depend on places the old map",
			},
		],
	},
	{
		file: `${SRC}/model.cpp`,
		suites: AGAIN,
		faults: [
			{
				id: "flower-keeps-its-seed",
				find: "if (rebuilds(program, last.given, given, limits)) return false;",
				replace: ";",
				breaks: "another seed has the last one's map",
			},
		],
	},
	{
		file: `${SRC}/thickness.cpp`,
		suites: AGAIN,
		faults: [
			{
				id: "flower-thin-tubes",
				find: "shapes[v].width *= known->second;",
				replace: ";",
				breaks: "stems are thinner than the text says",
			},
		],
	},
	{
		file: `${SRC}/skin.cpp`,
		suites: AGAIN,
		faults: [
			{
				id: "flower-material-of-no-line",
				find: "if (grown) gives(growths[record->source]->arguments);",
				replace: "",
				breaks: "a material that is none is looked for where the volume is defined",
			},
		],
	},
	{
		file: `${SRC}/fingerprint.cpp`,
		suites: [`${TESTS}/fingerprint_test.cpp`],
		faults: [
			{
				id: "flower-print-without-places",
				find: "print.add(at.y);",
				replace: "",
				breaks: "flowers that differ in a height alone have one fingerprint",
			},
			{
				id: "flower-print-by-name",
				find: "if (place == generalized_map::none) place = mentioned++;",
				replace: "place = volume.label;",
				breaks: "labels count by where the text defines them, which its document does not tell",
			},
		],
	},
	{
		file: `${SRC}/organ_corners.cpp`,
		suites: [`${TESTS}/skin_test.cpp`],
		faults: [
			{
				id: "flower-picture-in-steps",
				find: "corner.beside = std::min(corner.beside, place.y);",
				replace: "corner.beside = place.y;",
				breaks: "veins are painted in patches, a lobe at a time",
			},
			{
				id: "flower-picture-of-the-bearer",
				find: "const std::uint32_t organ = derived.records[derived.record_of[volume_[h]]].instance;",
				replace: "const std::uint32_t organ = 0;",
				breaks: "where organs touch one is painted with the other's middle",
			},
		],
	},
];
