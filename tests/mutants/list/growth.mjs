/** Trees by divisor functions: the language, and what it counts. */
const SRC = "wasm-core/src/models/growth";
const TESTS = "tests/core/models/growth";
const POPULATION = [`${TESTS}/population_test.cpp`, `${TESTS}/counts_test.cpp`];
const MISTAKES = [`${TESTS}/mistakes_test.cpp`, `${TESTS}/population_test.cpp`];

export default [
	{
		file: `${SRC}/populate.cpp`,
		suites: POPULATION,
		faults: [
			{
				id: "divisors-buds-are-never-used-up",
				find: "memories_[number].buds_used += grown;",
				replace: ";",
				breaks: "old wood makes branches without end, several from one bud",
			},
			{
				id: "divisors-deformed-for-good",
				find: "if (memory.gravitropism == outcome.gravitropism && memory.length == outcome.length) return true;",
				replace: "if (outcome.length == 1) return true;",
				breaks: "a branch that grew twice as long once does so for ever",
			},
			{
				id: "divisors-old-leaves-fall",
				find: "if (memory.leaves_step + 1 != step) return true;",
				replace: "",
				breaks: "leaves of long ago are about to fall, some of them twice",
			},
			{
				id: "divisors-branches-make-trunks",
				find: "if (plant_.shoots[number].trunk) outcome.child_trunks.emplace_back(&rule, chance);",
				replace: "outcome.child_trunks.emplace_back(&rule, chance);",
				breaks: "trunks sit on branches",
			},
			{
				id: "divisors-child-trunks-clock-is-its-parents",
				find: "trunk_born_.push_back(step);",
				replace: "trunk_born_.push_back(0);",
				breaks: "a child trunk is taken for a branch and bears as one",
			},
			{
				id: "divisors-child-trunk-as-large",
				find: "const float half = whole / 2, least",
				replace: "const float half = whole, least",
				breaks: "child trunks are as large as their parents",
			},
			{
				id: "divisors-luck-of-the-plant",
				find: "random_unit(seed_, hash_combine(outcome.buds->stream, bud), address)",
				replace: "random_unit(seed_, outcome.buds->stream, bud)",
				breaks: "the same buds of all branches fail, and trees of a text differ by far more",
			},
		],
	},
	{
		file: `${SRC}/reader.cpp`,
		suites: MISTAKES,
		faults: [
			{
				id: "divisors-chance-drawn-once-for-all",
				find: "rules_.repeatable &= !draws && !luck && !rule.probability.draws && (uses & bit(Word::order)) == 0;",
				replace: "",
				breaks: "what is drawn for one shoot all others of its age do as well",
			},
			{
				id: "divisors-lines-after-a-condition-ignored",
				find: "return at_ == end || wrong(here(), \"An arrow is expected here, not '%'.\", {found()});",
				replace: "return at_ = end, true;",
				breaks: "what stands between a condition and its arrow is passed over",
			},
			{
				id: "divisors-footprint-shifts-luck",
				find: "++expressions_[in_footprint_]",
				replace: "++expressions_[0]",
				breaks: "a tree changes when its volumes are written out in numbers",
			},
		],
	},
	{
		file: `${SRC}/volumes.cpp`,
		suites: [`${TESTS}/population_test.cpp`, `${TESTS}/mistakes_test.cpp`],
		faults: [
			{
				id: "divisors-drawn-numbers-have-no-end",
				find: "return std::floor(value * 100 + 0.5f) / 100;",
				replace: "return value;",
				breaks: "a tree changes when its volumes are written out in numbers",
			},
			{
				id: "divisors-first-tree-rule-only",
				find: "left -= weights[i];",
				replace: "left = -1;",
				breaks: "of divisor functions by chance it is always the first",
			},
		],
	},
	{
		file: `${SRC}/rules.cpp`,
		suites: MISTAKES,
		faults: [
			{
				id: "divisors-standard-after-the-texts-own",
				find: "rules.of_shoots.insert(rules.of_shoots.end(), std::make_move_iterator(own.begin()),",
				replace: "rules.of_shoots.insert(rules.of_shoots.begin(), std::make_move_iterator(own.begin()),",
				breaks: "conditions on ndv never hold, for it is worked out behind them",
			},
			{
				id: "divisors-given-twice-unsaid",
				find: "if (const DivisorFunction* const again = given_twice(rules))",
				replace: "if (const DivisorFunction* const again = given_twice(rules); again != nullptr && rules.tree.empty())",
				breaks: "of two divisor functions for branches one is passed over without a word",
			},
		],
	},
];
