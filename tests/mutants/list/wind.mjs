/** Wind: in the view and in files. */
export default [
	{
		file: "web/src/render/part_renderer.ts",
		suites: ["tests/web/render/part_renderer.test.ts"],
		faults: [
			{
				id: "wind-lost-shadows-stay-away",
				find: "this.#lights.restored();",
				replace: "",
				breaks: "when the graphics card comes back plants throw no shadows",
			},
			{
				id: "marks-share-buffers",
				find: "only.setAttribute(name, new BufferAttribute(values, 3));",
				replace: "only.setAttribute(name, values.length > 0 ? attribute : attribute);",
				suites: ["tests/web/render/part_marks.test.ts"],
				breaks: "a mark that goes takes the plant's buffers on the graphics card along",
			},
		],
	},
	{
		file: "web/src/plant/sway.ts",
		suites: ["tests/web/plant/sway.test.ts"],
		faults: [
			{
				id: "wind-hanging-stands",
				find: "const up = high - first >= first - low ? 1 : -1;",
				replace: "const up = 1;",
				breaks: "bunches, which hang, do not sway",
			},
		],
	},
	{
		file: "web/src/plant/point_sway.ts",
		suites: ["tests/web/plant/sway.test.ts", "tests/web/formats/wind_glb.test.ts"],
		faults: [
			{
				id: "wind-foot-slides",
				find: "const bend = TOP_AMPLITUDE * height * h * h * (1.5 - 0.5 * h);",
				replace: "const bend = TOP_AMPLITUDE * height * (0.1 + h * h * (1.4 - 0.5 * h));",
				breaks: "in the wind a tree slides over the ground",
			},
			{
				id: "wind-leaves-fly-off",
				find: "const [ox, oy, oz] = [place[0] - held[0], place[1] - held[1], place[2] - held[2]];",
				replace: "const [ox, oy, oz] = [place[0] - foot[0], place[1] - foot[1], place[2] - foot[2]];",
				breaks: "leaves leave their twigs in the wind",
			},
		],
	},
	{
		file: "web/src/formats/wind_glb.ts",
		suites: ["tests/web/formats/wind_glb.test.ts"],
		faults: [
			{
				id: "wind-file-feet-lost",
				find: "still: sway?.foot",
				replace: "",
				breaks: "leaves of a swaying GLB do not turn about their feet, and walls sway",
			},
		],
	},
	{
		file: "web/src/render/wind_shader.ts",
		suites: ["tests/e2e/wind.spec.ts: draws sways while the wind blows, and is at rest before, after and in pictures"],
		faults: [
			{
				id: "wind-in-pictures",
				find: "		value.set(0, 0);\n",
				replace: "",
				breaks: "pictures are of a plant that the wind has bent",
			},
		],
	},
];
