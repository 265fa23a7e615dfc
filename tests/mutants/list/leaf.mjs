/** The leaf: side veins, margin, blade, measures. */

export default [
	{
		file: "wasm-core/src/models/leaf/shape/side_veins.cpp",
		suites: ["tests/core/models/leaf/side_veins_test.cpp"],
		faults: [
			{
				id: "side-veins-two-to-a-tooth",
				find: "tooth[--i] = static_cast<std::int32_t>(--k);",
				replace: "tooth[--i] = static_cast<std::int32_t>(k - 1);",
				breaks: "two side veins may end in one tooth",
			},
			{
				id: "side-veins-miss-teeth",
				find: "if (plan_.course == Course::teeth) into_teeth",
				replace: "if (plan_.course == Course::arch) into_teeth",
				breaks: "craspedodromous veins end anywhere",
			},
			{
				id: "side-veins-on-the-left-upside-down",
				find: "if (side > 0) std::reverse(tips.begin(), tips.end());",
				replace: "",
				breaks: "teeth of the left side are taken from the tip down",
			},
			{
				id: "side-veins-do-not-arch",
				find: "angle -= turn;",
				replace: "angle -= 0;",
				breaks: "arches end at the margin",
			},
			{
				id: "side-veins-cross-the-next",
				find: "if (above && any_within(above->places, next, min_distance)) break;",
				replace: "",
				breaks: "arches run through the vein above",
			},
			{
				id: "lobe-veins-along-bays",
				find: "clear_of_bays[] = {0.022f, 0.011f, 0}",
				replace: "clear_of_bays[] = {0, 0, 0}",
				breaks: "the vein to a lobe grazes the bay beside it, and steps aside there",
			},
		],
	},
	{
		file: "wasm-core/src/models/leaf/shape/margin.cpp",
		suites: ["tests/core/models/leaf/side_veins_test.cpp"],
		faults: [
			{
				id: "margin-without-drawn-teeth",
				find: "margin.teeth.push_back(at);",
				replace: ";",
				breaks: "corners that stand out are no teeth",
			},
		],
	},
	{
		file: "wasm-core/src/models/leaf/shape/teeth.cpp",
		suites: ["tests/core/models/leaf/margin_test.cpp"],
		faults: [
			{
				id: "teeth-tips-forgotten",
				find: "if (out == 1) cut.margin.teeth.push_back",
				replace: "if (out == 0) cut.margin.teeth.push_back",
				breaks: "notches are taken for tips",
			},
		],
	},
	{
		file: "wasm-core/src/models/leaf/dress.cpp",
		suites: ["tests/core/models/leaf/leaf_dress_test.cpp"],
		faults: [
			{
				id: "petiole-as-thick-as-the-vein",
				find: "0.0005f * values[petiole_width]",
				replace: "0.0005f * values[vein]",
				breaks: "fine-veined leaves hang by a thread",
			},
		],
	},
	{
		file: "wasm-core/src/models/leaf/measures/measures.cpp",
		suites: ["tests/core/models/leaf/leaf_measures_test.cpp"],
		faults: [
			{
				id: "primaries-of-all-but-one",
				find: "static_cast<float>(headings.size() - 1)",
				replace: "static_cast<float>(headings.size())",
				breaks: "the angle between primaries is too small",
			},
		],
	},
];
