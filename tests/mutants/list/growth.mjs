/** Trees by divisor functions: the language and its counts. */
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
				find: "shoot_states_[number].buds_used += grown;",
				replace: ";",
				breaks: "old wood makes branches without end, several from one bud",
			},
			{
				id: "divisors-deformed-for-good",
				find: "if (state.gravitropism == outcome.gravitropism && state.length == outcome.length) return true;",
				replace: "if (outcome.length == 1) return true;",
				breaks: "a branch that grew twice as long once does so for ever",
			},
			{
				id: "divisors-old-leaves-fall",
				find: "if (range.step + 1 != step) continue;",
				replace: "",
				breaks: "leaves of long ago are about to fall, some of them twice",
			},
			{
				id: "divisors-own-leaves-stay",
				find: "{state.counted, state.of_branches}",
				replace: "{state.of_branches}",
				breaks: "no leaf ever falls: a shoot whose count is negative has given none to branches",
			},
			{
				id: "divisors-foliage-stays",
				find: "i < outcome.falling ? step : Leaf::never",
				replace: "Leaf::never",
				breaks: "no leaf of a species is about to fall in autumn",
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
				find: "rules_.repeatable &= !draws && !is_random && !rule.probability.draws && (uses & bit(Word::order)) == 0;",
				replace: "",
				breaks: "what is drawn for one shoot all others of its age do as well",
			},
			{
				id: "divisors-lines-after-a-condition-ignored",
				find: "return at_ == end || wrong(here(), message(messages::growth::arrow_expected, found_text()));",
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
				find: "rules.of_shoots.insert(rules.of_shoots.end(), std::make_move_iterator(own_shoot_rules.begin()),",
				replace: "rules.of_shoots.insert(rules.of_shoots.begin(), std::make_move_iterator(own_shoot_rules.begin()),",
				breaks: "conditions on ndv never hold, for it is worked out behind them",
			},
			{
				id: "divisors-given-twice-unsaid",
				find: "if (const DivisorFunction* const duplicate = given_twice(rules))",
				replace:
					"if (const DivisorFunction* const duplicate = given_twice(rules); duplicate != nullptr && rules.tree.empty())",
				breaks: "of two divisor functions for branches one is passed over without a word",
			},
		],
	},
	{
		file: `${SRC}/populate.cpp`,
		suites: [`${TESTS}/population_test.cpp`],
		faults: [
			{
				id: "foliage-not-of-new-branches",
				find: "if (!add_foliage(each, step, outcome)) return false;",
				replace: ";",
				breaks: "branches are bare in the year in which they come",
			},
			{
				id: "foliage-for-ever",
				find: "step + outcome.foliage_steps, Leaf::never - 1",
				replace: "Leaf::never - 1, Leaf::never - 1",
				breaks: "old wood keeps its leaves, and crowns fill up from within",
			},
		],
	},
	{
		file: `${SRC}/volume_shape.hpp`,
		suites: [`${TESTS}/form_test.cpp`],
		faults: [
			{
				id: "growth-volumes-without-a-middle",
				find: "middle_(volume.middle * volume.middle)",
				replace: "middle_(volume.base * volume.top)",
				breaks: "domes and spindles are frustums",
			},
		],
	},
	{
		file: `${SRC}/form.cpp`,
		suites: [`${TESTS}/form_test.cpp`],
		faults: [
			{
				id: "growth-canes-lie-down",
				find: "if (shoot.order == 1 && habit_.cordon > 0)",
				replace: "if (shoot.order == 1 && habit_.cordon < 0)",
				breaks: "canes of a trained vine leave its arm to all sides",
			},
		],
	},
	{
		file: `${SRC}/standard.hpp`,
		suites: [`${TESTS}/counts_test.cpp`],
		faults: [
			{
				id: "divisors-factor-of-trunks-alone",
				find: "ndv = D(B * k) - D(B * (k - 1))",
				replace: "ndv = D(k) - D(k - 1)",
				breaks: "B of equation 5 does nothing to branches",
			},
		],
	},
	{
		file: `${SRC}/foliage.cpp`,
		suites: [`${TESTS}/form_test.cpp`],
		faults: [
			{
				id: "growth-foliage-falls-in-summer",
				find: "return !population_.has_foliage || (!habit_.evergreen && habit_.season >= autumn);",
				replace: "return true;",
				breaks: "an oak has red leaves in June, and a spruce at all times",
			},
			{
				id: "growth-leaves-fall-together",
				find: "first_fall + fall_spread * falls_.unit(address)",
				replace: "first_fall + 0.5f * fall_spread",
				breaks: "all leaves of a tree fall on one day",
			},
			{
				id: "growth-evergreens-shed",
				find: "return !habit_.evergreen &&",
				replace: "return",
				breaks: "spruces are bare in winter",
			},
			{
				id: "growth-leaves-of-another-turn",
				find: "noise.about[batch_size] = first_turn + golden_turn * static_cast<float>(k);",
				replace: "noise.about[batch_size] = first_turn + golden_turn * static_cast<float>(batch_size);",
				breaks: "leaves that are worked out with others hang elsewhere",
			},
		],
	},
	{
		file: `${SRC}/leaf_poses.cpp`,
		suites: [`${TESTS}/leaf_poses_test.cpp`],
		faults: [
			{
				id: "growth-leaves-turned-askew",
				find: "(first ? zx : (second ? yz : three))",
				replace: "(first ? zx : (second ? three : yz))",
				breaks: "some leaves stand askew to their twig",
			},
			{
				id: "growth-leaves-alike",
				find: "{level * around.cosine, level * around.sine, stray * noise.height}",
				replace: "{level * around.cosine, level * around.cosine, stray * noise.height}",
				breaks: "leaves are strewn to one side",
			},
		],
	},
	{
		file: "web/src/models/growth/year.ts",
		suites: ["tests/web/models/growth/year.test.ts"],
		faults: [
			{
				id: "growth-evergreens-turn",
				find: "if (evergreen) return SUMMER;",
				replace: "",
				breaks: "spruces are yellow in autumn",
			},
		],
	},
];
