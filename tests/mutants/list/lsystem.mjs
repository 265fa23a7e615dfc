/** L-systems. */
const SRC = "wasm-core/src";
const TESTS = "tests/core";

export default [
	{
		file: `${SRC}/lsystem/syntax/compiler.cpp`,
		suites: [`${TESTS}/models/grammar/limits_test.cpp`],
		faults: [
			{
				id: "successor-functions-cost-as-sums",
				find: "result.cost = (cost_of(program.code, result.code) + result.words) / 32;",
				replace: "result.cost = (result.code.size() + result.words) / 32;",
				breaks: "a text of sines and draws takes seven seconds within its budget",
			},
		],
	},
	{
		file: `${SRC}/lsystem/syntax/production_reader.cpp`,
		suites: [`${TESTS}/lsystem/limits_test.cpp`],
		faults: [
			{
				id: "production-label-declared-names",
				find: "declared_.add(tokens_[i + 2].text);",
				replace: "{}",
				breaks: "a condition that is a #define alone is taken for the successor of a label",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/bound_program.cpp`,
		suites: [`${TESTS}/lsystem/limits_test.cpp`],
		faults: [
			{
				id: "bound-last-input-counts",
				find: "return number == Names::none ? nullptr : &given_[places_[number]];",
				replace: "return number == Names::none ? nullptr : &given_.back();",
				breaks: "a constant takes the value of another",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/derivation.cpp`,
		suites: [`${TESTS}/lsystem/derivation_test.cpp`, `${TESTS}/lsystem/open_derivation_test.cpp`],
		faults: [
			{
				id: "derivation-cut-modules-counted",
				find: "next_.string.modules -= rest.modules;",
				replace: "",
				breaks: "the length of a string counts what was cut off",
			},
			{
				id: "derivation-answers-stay",
				find: "  answered_ = false;\n  ++steps_;",
				replace: "  ++steps_;",
				breaks: "a question is taken as answered in the next step",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/derivation.cpp`,
		suites: [`${TESTS}/lsystem/derivation_trace_test.cpp`],
		faults: [
			{
				id: "derivation-broken-step-stays",
				find: "    std::swap(now_, next_);\n    at_rest_ = true;",
				replace: "    at_rest_ = true;",
				breaks: "the last string is that of a step which came to a limit after it rewrote",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/neighbourhood.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "doubles-lost-in-contexts",
				find: "if (registers.precise != nullptr) {",
				replace: "if (false) {",
				breaks: "in double precision a production does not know the parameters of its neighbours",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/bound_program.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "doubles-of-given-floats",
				find: "if (!program_.code.doubles) return value;",
				replace: "return value;",
				breaks: "a step of 0.02 that a slider gives is no 0.02 in double precision",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/words.hpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "doubles-not-written-by-the-turtle",
				find: "if (!has_doubles(*module)) return;",
				replace: "return;",
				breaks: "in double precision productions do not see what ?P was given",
			},
		],
	},
	{
		file: `${SRC}/lsystem/trace/refusals.cpp`,
		suites: [`${TESTS}/lsystem/derivation_trace_test.cpp`],
		faults: [
			{
				id: "refusals-draw-for-every-step-alike",
				find: "if (step) machine_.decide_at(*step);",
				replace: "",
				breaks: "conditions that draw are reported as if each step drew the same",
			},
			{
				id: "refusals-brackets-unsaid",
				find: "if (!left && begins_branch(module, wanted.symbol))",
				replace: "if (false)",
				breaks: "the reason does not name the branch that the required neighbour is in",
			},
			{
				id: "refusals-bracket-of-any-branch",
				find: "levels.back() = {current, false};",
				replace: "levels.back().last = current;",
				breaks: "a branch that is closed somewhere before is reported as if nothing were between",
			},
		],
	},
	{
		file: `${SRC}/lsystem/syntax/production_remarks.cpp`,
		suites: [`${TESTS}/lsystem/remarks_test.cpp`],
		faults: [
			{
				id: "remarks-weights-behind-any",
				find: "(!has_weight(production) || of.alone)) line",
				replace: "true) line",
				breaks: "a production that competes by weight with an earlier one is reported as never used",
			},
			{
				id: "remarks-conditions-by-formal-name",
				find: 'if (production.formals[i].name == name) return "\\x1f" + std::to_string(i);',
				replace: "if (false) return {};",
				breaks: "two productions with the same condition are not known as such where a parameter is called otherwise",
			},
			{
				id: "remarks-contexts-of-the-axiom-alone",
				find: "if (may_end[pair.before] && may_begin[pair.after]) return nullptr;",
				replace: "if (pair.before == before && pair.after == after) return nullptr;",
				breaks: "a context that is met after some steps is reported as one that a bracket prevents",
			},
		],
	},
	{
		file: `${SRC}/expression/expression.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "macros-without-a-limit",
				find: "if (macros_.nodes > Macros::max_nodes)",
				replace: "if (macros_.nodes > 4 * Macros::max_nodes)",
				breaks: "functions that call each other take more memory than the text says",
			},
			{
				id: "macros-first-argument-for-all",
				find: "const std::size_t begin = call.begins[formal] - call.begins[0];",
				replace: "const std::size_t begin = 0;",
				breaks: "the second argument of a function is the first as well",
			},
		],
	},
	{
		file: `${SRC}/lsystem/syntax/parser.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "backslash-joins-statements",
				find: "whole = !cpfg || begins_statement(end);",
				replace: "whole = !cpfg;",
				breaks: "a roll at the end of a production joins it with the next production",
			},
			{
				id: "backslash-joins-strings-of-the-paper",
				find: "whole = !cpfg || begins_statement(end);",
				replace: "whole = begins_statement(end);",
				breaks: "a roll at the end of a line is lost in texts of bunches, whose links are frozen",
			},
		],
	},
	{
		file: `${SRC}/lsystem/trace/derivation_trace.cpp`,
		suites: [`${TESTS}/lsystem/derivation_trace_test.cpp`, `${TESTS}/lsystem/derivation_trace_published_test.cpp`],
		faults: [
			{
				id: "chronicle-reasons-take-work-of-the-plant",
				suites: [`${TESTS}/models/grammar/limits_test.cpp`],
				find: "own_limits.budget = &budget;\n  Refusals",
				replace: "Refusals",
				breaks: "tracing a step leaves less work for drawing, so that the plant has fewer leaves",
			},
			{
				id: "chronicle-last-border-stays",
				find: "for (; border_ < borders_.size(); ++border_) borders_[border_] = new_;",
				replace: "",
				breaks: "a window's last module has the wrong descendants",
			},
			{
				id: "chronicle-broken-step-told",
				find: "entry.fires = {};",
				replace: "",
				breaks: "productions of a step that a limit ended seem to have fired",
			},
			{
				id: "chronicle-ancestor-of-copied",
				find: "before.old_end + (module - before.new_end)",
				replace: "module",
				breaks: "what was copied behind a module that grew comes from another one",
			},
			{
				id: "chronicle-decomposed-by-the-parent",
				find: "i < parts_.size() ? parts_[i] : production_",
				replace: "production_",
				breaks: "what a decomposition writes seems to be written by the production before it",
			},
			{
				id: "chronicle-answers-before-they-are-given",
				find: '"asked" + queries_[i] +',
				replace: '"asked" + parameters_text(module) +',
				breaks: "a question seems to have been asked with its answer",
			},
			{
				id: "chronicle-hears-another-drawing",
				find: "  string_ = nullptr;\n",
				replace: "",
				breaks: "what a limit left untold is told of a string that is gone, or of another",
			},
			{
				id: "chronicle-idle-steps",
				find: "options.environment == nullptr ? derived->steps : trace.steps()",
				replace: "trace.steps()",
				breaks: "steps at the end in which nothing happens are counted",
			},
		],
	},
	{
		file: `${SRC}/models/bunch/paper/growth.cpp`,
		suites: [`${TESTS}/models/bunch/paper/growth_test.cpp`],
		faults: [
			{
				id: "growth-owner-is-the-asker",
				find: "owners_.push_back({lineage.module,",
				replace: "owners_.push_back({0,",
				breaks: "every berry in the way is the first module's",
			},
			{
				id: "growth-touching-by-nothing",
				find: "depth < 0.005f;",
				replace: "depth < -1;",
				breaks: "what is only touched overlaps by 0",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/machine.cpp`,
		suites: [
			`${TESTS}/lsystem/random_values_test.cpp`,
			`${TESTS}/lsystem/development_test.cpp`,
			`${TESTS}/lsystem/derivation_test.cpp`,
		],
		faults: [
			{
				id: "machine-weights-unheeded",
				find: "i < range.end && left >= 0; ++i",
				replace: "i < range.end && drawn == nullptr; ++i",
				breaks: "the first of several weighted productions is always taken",
			},
			{
				id: "machine-chance-but-once",
				find: "if (stepping_) sources_.address = hash_combine(address, step_);",
				replace: "",
				breaks: "a delay by chance fails for ever",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/machine.cpp`,
		suites: [`${TESTS}/lsystem/contexts_test.cpp`],
		faults: [
			{
				id: "machine-neighbours-of-another",
				find: "  if (drawn != nullptr && drawn != tried && drawn->in_context) sees(*drawn);",
				replace: "",
				breaks: "a production that chance has chosen reads the neighbours of one that was tried after it",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/neighbourhood.cpp`,
		suites: [`${TESTS}/lsystem/contexts_test.cpp`],
		faults: [
			{
				id: "neighbourhood-branch-not-left",
				find: "      last = there[1];",
				replace: "",
				breaks: "what stands in a branch is taken for the way to what stands behind it",
			},
			{
				id: "neighbourhood-branch-hides",
				find: "pending = there[2];",
				replace: "untold = none;",
				breaks: "what is behind a branch is not seen from before it",
			},
			{
				id: "neighbourhood-one-before",
				find: "if (i > wanted.begin) place = before_.data()[place];",
				replace: "",
				breaks: "of several modules on the left each is looked for right before the module",
			},
			{
				id: "neighbourhood-one-branch",
				find: "if (follow(i + 1, wanted.closed, inside, registers, looked) != nullptr) break;",
				replace:
					"if (follow(i + 1, wanted.closed, inside, registers, looked) == nullptr) return nullptr;\n      break;",
				breaks: "of several branches only the first is looked at",
			},
			{
				id: "neighbourhood-way-for-free",
				find: "  looked += at - at_;",
				replace: "",
				breaks: "steps in which chance rewrites nothing cost nothing, however long the string",
			},
			{
				id: "neighbourhood-look-for-free",
				find: "at += words_of(*at), ++looked)",
				replace: "at += words_of(*at))",
				breaks: "what looks in vain costs nothing",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/skippable_symbols.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "language-images-lead-nowhere",
				find: "(open == 0 && means(symbol, leads_on))",
				replace: "false",
				breaks: "?P does not know of what is drawn in the place of a module before it",
			},
			{
				id: "language-images-close-polygons",
				find: "has_image(symbol) || means(symbol, draws_polygons) ||",
				replace: "has_image(symbol) ||",
				breaks: "?P does not know of a polygon that a module before it has opened",
			},
		],
	},
	{
		file: `${SRC}/lsystem/turtle/interpretation.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "language-one-sense",
				find: "Notation::cpfg ? -1.0f : 1.0f",
				replace: "Notation::cpfg ? 1.0f : 1.0f",
				breaks: "cpfg's texts turn as the paper's do",
			},
			{
				id: "language-brackets-end-polygons",
				find: "if (polygons_.empty()) return note",
				replace: "if (polygons_.empty() || !stack_.empty()) return note",
				breaks: "a polygon cannot end in a branch",
			},
		],
	},
	{
		file: `${SRC}/lsystem/derivation/derivation.cpp`,
		suites: [`${TESTS}/lsystem/language_test.cpp`],
		faults: [
			{
				id: "language-shallow-decomposition",
				find: "depth < bound_.depths[0] &&",
				replace: "depth < 1 &&",
				breaks: "decomposition goes no deeper than once",
			},
		],
	},
	{
		file: `${SRC}/lsystem/turtle/turtle.cpp`,
		suites: [`${TESTS}/lsystem/turtle_test.cpp`],
		faults: [
			{
				id: "turtle-pitch-upside-down",
				find: "turtle.heading * cosine + turtle.up * sine",
				replace: "turtle.heading * cosine - turtle.up * sine",
				breaks: "& pitches up",
			},
			{
				id: "turtle-length-drifts",
				find: "return v * (1.5f - 0.5f * glm::dot(v, v)); }",
				replace: "return v; }",
				breaks: "the turtle's steps drift after thousands of turns",
			},
		],
	},
	{
		file: `${SRC}/lsystem/syntax/remarks.cpp`,
		suites: [`${TESTS}/lsystem/remarks_test.cpp`],
		faults: [
			{
				id: "remarks-s-as-a-symbol-unsaid",
				find: 'production.predecessor == "S" &&',
				replace: 'production.predecessor == "" &&',
				breaks: "nothing says why a symbol S draws spheres",
			},
			{
				id: "remarks-unknown-define-unsaid",
				find: "if (declared.find(given.name) == Names::none)",
				replace: "if (false)",
				breaks: "a slider that changes nothing says nothing",
			},
		],
	},
	{
		file: "wasm-core/grammars/grammar/quadratic-gosper.lsys",
		suites: [`${TESTS}/lsystem/conformance_shape_test.cpp`],
		faults: [
			{
				id: "published-edge-lost",
				find: "Fr+Fl+Fl Fr+Fl-Fr",
				replace: "Fr+Fl Fr+Fl-Fr",
				breaks: "a published curve is not what was published",
			},
		],
	},
	{
		file: "wasm-core/grammars/grammar/anabaena.lsys",
		suites: [`${TESTS}/lsystem/conformance_test.cpp`],
		faults: [
			{
				id: "published-cells-divide-one-way",
				find: "al --> bl ar",
				replace: "al --> ar bl",
				breaks: "the filament's cells divide in one direction only",
			},
		],
	},
	{
		file: "wasm-core/grammars/grammar/leaf.lsys",
		suites: [`${TESTS}/lsystem/conformance_leaf_test.cpp`],
		faults: [
			{
				id: "published-leaf-crosses-itself",
				find: "L(i) : i<=k --> L(i+1) [+(alpha*i) &(beta*i*24/k) V(i/k).]",
				replace: "L(i) : i<=k --> [+(alpha*i) &(beta*i*24/k) V(i/k).] L(i+1)",
				breaks: "the leaf's corners come in the order of the print, which crosses itself",
			},
		],
	},
];
