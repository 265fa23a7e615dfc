/** Any text as a plant. */
const CORE = "wasm-core/src";
const WEB = "web/src";
const TESTS = "tests/core";

export default [
	{
		file: `${CORE}/foundation/work_budget.hpp`,
		suites: [`${TESTS}/foundation/work_budget_test.cpp`],
		faults: [
			{
				id: "budget-share-for-ever",
				find: "      budget_.work_ = whole_;",
				replace: "",
				breaks: "nothing is left to draw what a derivation that reached its limit gave",
			},
			{
				id: "budget-holds-too-much",
				find: "if (bytes > bytes_ - held_) return false;",
				replace: "if (held_ > bytes_) return false;",
				breaks: "a plant takes more memory than its limit",
			},
			{
				id: "budget-time-not-shared",
				find: ">= static_cast<double>(work_);",
				replace: ">= static_cast<double>(total_);",
				breaks: "a text that reaches its time limit has no time left to draw what it derived",
			},
			{
				id: "budget-never-looks-again",
				find: "next_look_ = spent_ + look_interval;",
				replace: "next_look_ = ~std::uint64_t{0};",
				breaks: "grow --seconds never ends before the plant is whole",
			},
			{
				id: "budget-time-of-a-share-ends-all",
				find: "    time_is_over_ = false;\n    next_look_ = time",
				replace: "    next_look_ = time",
				breaks: "a text that reaches its time limit shows nothing",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/neighbours.cpp`,
		suites: [`${TESTS}/models/grammar/limits_test.cpp`],
		faults: [
			{
				id: "neighbours-looks-uncounted",
				find: "budget_.spend(looked / 8);",
				replace: "",
				breaks: "?E with a large radius takes minutes without an end",
			},
			{
				id: "neighbours-light-uncounted",
				find: "budget_.spend(ends_.size() + matter.cells() * lamps / 8);",
				replace: "",
				breaks: "?E with a radius of its own each takes minutes without an end",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/sketch.cpp`,
		suites: [`${TESTS}/models/grammar/limits_test.cpp`],
		faults: [
			{
				id: "sketch-bytes-uncounted",
				find: "if (budget == nullptr || budget->hold(bytes)) return true;",
				replace: "return true;",
				breaks: "surfaces and balls make a file of gigabytes",
			},
			{
				id: "sketch-unknown-surfaces-all-named",
				find: "if (unknown_.size() == max_unknown || unknown_.contains(name)) return;",
				replace: "if (unknown_.contains(name)) return;",
				breaks: "a text of unknown surfaces gives a note for each",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/model.cpp`,
		suites: [`${TESTS}/models/grammar/limits_test.cpp`],
		faults: [
			{
				id: "grammar-cut-short-unmarked",
				find: "plant.cut_short = cut_short_by(*limits.budget);",
				replace: "",
				breaks: "scripts cannot tell a plant that a limit cut short from a whole one",
			},
			{
				id: "grammar-limit-in-drawing-shows-nothing",
				find: "if (drawing_error.reason != Reason::none && drawing_error.reason != Reason::limit) return drawing_error;",
				replace: "if (drawing_error.reason != Reason::none) return drawing_error;",
				breaks: "a homomorphism that reaches a limit is an error that shows nothing",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/outlines.cpp`,
		suites: [`${TESTS}/models/grammar/outlines_test.cpp`],
		faults: [
			{
				id: "outlines-without-offset",
				find: "return outline.offset + power(",
				replace: "return power(",
				breaks: "a surface has another outline than the leaf of its name",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/areas.cpp`,
		suites: [`${TESTS}/models/grammar/areas_test.cpp`],
		faults: [
			{
				id: "areas-reach-in-ways",
				find: "way / length, wanted",
				replace: "way, wanted",
				breaks: "how far a way reaches depends on how long it is said to be",
			},
		],
	},
	{
		file: `${CORE}/lsystem/syntax/parser.cpp`,
		suites: ["tests/core/lsystem/mistakes_test.cpp"],
		faults: [
			{
				id: "parser-eats-unknown-lines",
				find: "is_foreign_line(at) || is_unknown_line(at) ||",
				replace: "is_foreign_line(at) ||",
				breaks: "a line that is no statement goes on with the production before it",
			},
			{
				id: "arrow-on-the-next-line-goes-on",
				find: "    if (begins_with_arrow(end_)) return arrow_alone(end_);\n    return production",
				replace: "    return production",
				breaks: "of an arrow on the next line something is said that has nothing to do with it",
			},
			{
				id: "assignments-go-on",
				find: "foreign_arrow(at) != none || is_assignment(at) ||",
				replace: "foreign_arrow(at) != none ||",
				breaks: "n = 5 goes on with the production before it",
			},
		],
	},
	{
		file: `${CORE}/mesh/polygon.cpp`,
		suites: [`${TESTS}/mesh/polygon_test.cpp`],
		faults: [
			{
				id: "polygon-lines-are-triangles",
				find: "if (!(glm::length(twice) > flat * longest)) return;",
				replace: "",
				breaks: "a corner on a line between its neighbours is a triangle",
			},
			{
				id: "polygon-looks-uncounted",
				find: "if (budget != nullptr) budget->spend(1 + (clipper.looks() + corners.size()) / looks_a_unit);",
				replace: "",
				suites: [`${TESTS}/models/grammar/limits_test.cpp`],
				breaks: "many polygons that cross themselves take a minute",
			},
			{
				id: "polygon-every-corner-an-ear",
				find: "if (turn >= 0 && is_ear(at)) return at;",
				replace: "if (turn >= 0) return at;",
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
				find: "segment.radius *= girth.width_factor;",
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
				find: "colour == 1 ? natural : colour",
				replace: "colour",
				breaks: "leaves of a text without colours are brown",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/dressing.cpp`,
		suites: [`${TESTS}/models/grammar/dressing_test.cpp`, `${TESTS}/models/grammar/grammar_model_test.cpp`],
		faults: [
			{
				id: "dressing-no-corners",
				find: ".jointed = false, .corner = cosine_of_corner}",
				replace: ".jointed = false}",
				breaks: "strokes of a curve bend into each other",
			},
			{
				id: "dressing-leaves-lit-at-their-feet",
				find: "std::max(base, visible_sky.at(point_on_axis(organ, organ.scale + visible_sky.edge())))",
				replace: "base",
				breaks: "leaves at the outside of what is dense are as dark as its inside",
			},
			{
				id: "dressing-never-simpler",
				find: "counts[organ.tag] > many_surfaces",
				replace: "false",
				breaks: "tens of thousands of leaves have as many triangles each as one alone",
			},
			{
				id: "dressing-never-coarse",
				find: "options.coarse && segments.size() >= many_in_preview",
				replace: "false",
				breaks: "a character typed beside 10,000 segments takes four times as long",
			},
			{
				id: "dressing-few-coarse",
				find: "options.coarse && segments.size() >= many_in_preview",
				replace: "options.coarse",
				breaks: "a small plant has pentagons for stems while it is dragged",
			},
		],
	},
	{
		file: `${WEB}/models/grammar/request.ts`,
		suites: ["tests/web/models/grammar/grown.test.ts"],
		faults: [
			{
				id: "grammar-fine-in-passing",
				find: '\t\tpreview && "coarse",\n',
				replace: "",
				breaks: "a step of a drag brings meshes that only a plant at rest needs",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/plate.cpp`,
		suites: [`${TESTS}/models/grammar/plate_test.cpp`],
		faults: [
			{
				id: "plate-thin-at-bends",
				find: "std::min(areas[corner] / length, max_mitre)",
				replace: "std::min(0.98f, max_mitre)",
				breaks: "bent blades are thinner than said",
			},
			{
				id: "plate-walls-within",
				find: "place[used[k]] = place[cells.put(used[k])];",
				replace: "cells.put(used[k]);",
				breaks: "a slit in a blade has two walls in it",
			},
			{
				id: "plate-places-by-cells-alone",
				find: "around < 27",
				replace: "around < 0",
				breaks: "a walk that comes back beside a cell's border leaves a wall within",
			},
			{
				id: "plate-walls-inside-out",
				find: "put(mesh.indices, top, low, far_low);",
				replace: "put(mesh.indices, top, far_low, low);",
				breaks: "half of a blade's edge is seen from within",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/blades.cpp`,
		suites: [`${TESTS}/models/grammar/plate_test.cpp`],
		faults: [
			{
				id: "blades-organ-by-order",
				find: "organ.push_back(polygon.organ);",
				replace: "organ.push_back(static_cast<std::uint32_t>(organ.size()));",
				breaks: "another polygon lights up than the one that is pointed at",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/measures/axes.cpp`,
		suites: [`${TESTS}/models/grammar/measures_test.cpp`],
		faults: [
			{
				id: "axes-without-lines",
				find: "if (line > before && !drawn.back()) {",
				replace: "if (!drawn.back()) {",
				breaks: "brackets that only bear leaves count as axes",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/measures/leaf_coverage.cpp`,
		suites: [`${TESTS}/models/grammar/measures_test.cpp`],
		faults: [
			{
				id: "clothing-of-one-length",
				find: "<= leaves_[i].length * leaves_[i].length;",
				replace: "<= leaves_[0].length * leaves_[0].length;",
				breaks: "small leaves clothe as far as large ones",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/measures/measures.cpp`,
		suites: [`${TESTS}/models/grammar/measures_test.cpp`],
		faults: [
			{
				id: "measures-balls-are-points",
				find: "organ.tag == ball_tag ? std::fabs(organ.scale) : 0",
				replace: "0.0f",
				breaks: "what ends in a ball is measured to its middle",
			},
			{
				id: "measures-petals-are-leaves",
				find: '.material == "blade";',
				replace: '.material != "skin";',
				breaks: "a rose's petals are leaf area",
			},
		],
	},
	{
		file: `${CORE}/models/grammar/areas.cpp`,
		suites: [`${TESTS}/models/grammar/measures_test.cpp`],
		faults: [
			{
				id: "areas-size-in-metres",
				find: "std::max({extent.x, extent.y, extent.z}) / metres",
				replace: "std::max({extent.x, extent.y, extent.z})",
				breaks: "leaves of a topiary in millimetres are a thousandth as long",
			},
		],
	},
	{
		file: `${WEB}/specimen/constants.ts`,
		suites: ["tests/web/models/grammar/document.test.ts", "tests/web/models/flower/values.test.ts"],
		faults: [
			{
				id: "constants-unsorted",
				find: "[...values].sort(([a], [b]) => (a < b ? -1 : 1))",
				replace: "[...values]",
				breaks: "the same constants in another order are another document",
			},
			{
				id: "constants-strangers-pass",
				find: "!known.includes(each)",
				replace: "false",
				breaks: "an address with a name that its text does not define is answered as if it had none",
			},
		],
	},
	{
		file: `${WEB}/models/for_text.ts`,
		suites: ["tests/web/models/grammar/document.test.ts"],
		faults: [
			{
				id: "for-text-first-model",
				find: "models.find(({ details }) => details.some(({ claims }) => claims?.(text))) ??",
				replace: "models[0] ??",
				breaks: "every dropped text is a bunch's",
			},
		],
	},
];
