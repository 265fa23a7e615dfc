/** How the plants of a stand are drawn: at which level, in how many draws, with which shadows. */
const WEB = "tests/web/models/stand";

export default [
	{
		file: "web/src/models/stand/render/crowd.ts",
		suites: [`${WEB}/crowd.test.ts`],
		faults: [
			{
				id: "stand-draws-all-anew-in-each-frame",
				find: "if (each.wanted !== each.shown) this.#showLevel(each);",
				replace: "this.#showLevel(each);",
				breaks: "every step of a walker sends all plants to the graphics card",
			},
			{
				id: "stand-borne-sways-by-itself",
				find: "const swaying = parent[plant] < 0 ? plant : parent[plant];",
				replace: "const swaying = plant;",
				breaks: "bunches come off their vines in the wind",
			},
			{
				id: "stand-all-finest-at-once",
				find: "if (candidates.length > NEAREST) candidates.length = NEAREST;",
				replace: "",
				breaks: "where many trees are near there are too many draws",
			},
			{
				id: "stand-lost-card-stays-empty",
				find: "		this.#begin(stand);\n		this.show(stand);",
				replace: "		this.show(stand);",
				breaks: "when the graphics card comes back the plants do not",
			},
			{
				id: "stand-lost-card-dims-the-chosen",
				find: "this.mark(marked);",
				replace: "void marked;",
				breaks: "when the graphics card comes back the chosen plant has its ring and is dark",
			},
			{
				id: "stand-counts-what-is-not-there",
				find: "if (layers.length === 0) return;",
				replace: "",
				breaks: "a plant without triangles makes all others coarse",
			},
		],
	},
	{
		file: "web/src/render/level_choice.ts",
		suites: [`${WEB}/parts.test.ts`],
		faults: [
			{
				id: "stand-levels-pop",
				find: "const remaining = Math.ceil((STEPS * (size - leastSize)) / (BAND * leastSize));",
				replace: "const remaining = STEPS + 0 * BAND;",
				breaks: "trees jump from one level of detail to the next",
			},
		],
	},
	{
		file: "web/src/models/stand/render/drawn_plant.ts",
		suites: [`${WEB}/crowd.test.ts`],
		faults: [
			{
				id: "stand-counts-what-is-out-of-sight",
				find: "if (!cell.seen) continue;",
				replace: "",
				breaks: "plants behind the viewer make those before them coarse",
			},
		],
	},
	{
		file: "web/src/models/stand/render/batch.ts",
		suites: [`${WEB}/crowd.test.ts`],
		faults: [
			{
				id: "stand-stems-have-holes",
				find: "Math.min(1, 2 - 2 * faded), bright);",
				replace: "1 - faded, bright);",
				breaks: "stems between two levels of detail are rows of dots",
			},
			{
				id: "stand-stems-have-holes-half-way",
				find: "this.#setInstance(slot, slot.other, faded > 0 ? level + 1 : -1, Math.min(1, 2 * faded), bright);",
				replace:
					"if (faded > 0.5) this.object.setVisibleAt(slot.now, false);\n\t\tthis.#setInstance(slot, slot.other, faded > 0 ? level + 1 : -1, 0.4, bright);",
				breaks: "the farther of two levels of detail comes as dots, and the nearer has gone",
			},
			{
				id: "stand-kept-beside-the-card",
				find: "if (each instanceof BufferAttribute) releaseAfterUpload(each);",
				replace: "void (each instanceof BufferAttribute && shed);",
				breaks: "all meshes of a stand are in memory twice",
			},
		],
	},
	{
		file: "web/src/models/stand/render/shaded.ts",
		suites: [`${WEB}/parts.test.ts`],
		faults: [
			{
				id: "stand-shadows-stay-behind",
				find: "const toStep = (value: number) => step * Math.round(value / step);",
				replace: "const toStep = (value: number) => 0 * step * value;",
				breaks: "who walks on comes to where nothing throws a shadow",
			},
		],
	},
];
