/** Designing flowers: fitting, assembling, merging, handles. */
const DESIGN = "web/src/models/flower/design";
const VIEWS = "web/src/models/flower/ui/design";
const TESTS = "tests/web/models/flower/design";
const ASSEMBLED = [`${TESTS}/assembled.test.ts`];
const MERGE = [`${TESTS}/merge.test.ts`];
const SCENES = [`${TESTS}/scenes.test.ts`];

export default [
	{
		file: "web/src/models/flower/ui/chosen_volume.ts",
		suites: ["tests/web/models/flower/chosen_volume.test.ts"],
		faults: [
			{
				id: "volume-first-of-its-name",
				find: " && matches++ === nth",
				replace: "",
				breaks: "another petal than the one clicked on is chosen",
			},
			{
				id: "volume-of-any-descent",
				find: "first[last ?? first.length - 1]",
				replace: "first[first.length - 1]",
				breaks: "a volume of the same name on another ring is chosen once the clicked one is gone",
			},
			{
				id: "volume-behind-what-it-bears",
				find: "const parentOrCount = Math.min(parent[volume], count);",
				replace: "const parentOrCount = parent[volume] > volume ? count : parent[volume];",
				breaks: "where a text splits, what is clicked on is not chosen",
			},
		],
	},
	{
		file: `${DESIGN}/polynomial.ts`,
		suites: [`${TESTS}/polynomial.test.ts`],
		faults: [
			{
				id: "flower-fit-of-one-reflection-less",
				find: "for (let k = 0; k < size; k++) reflect(rows, k);",
				replace: "for (let k = 0; k < size - 1; k++) reflect(rows, k);",
				breaks: "the last coefficient is of one sample alone",
			},
		],
	},
	{
		file: `${DESIGN}/sections.ts`,
		suites: ASSEMBLED,
		faults: [
			{
				id: "flower-stalked-leaves-of-one-size",
				find: "LEAF{part=H/",
				replace: "LEAF{part=1+0*H/",
				breaks: "leaves on stalks do not become smaller up the stem",
			},
		],
	},
	{
		file: `${VIEWS}/floral_diagram.ts`,
		suites: SCENES,
		faults: [
			{
				id: "diagram-whorls-outwards",
				find: "(ring - Math.hypot(x, y)) / BETWEEN",
				replace: "(Math.hypot(x, y) - ring) / BETWEEN",
				breaks: "whoever draws the innermost whorl farther in gets none",
			},
		],
	},
	{
		file: `${DESIGN}/whorl.ts`,
		suites: ASSEMBLED,
		faults: [
			{
				id: "flower-ring-of-one-step",
				find: "{rings.length + 1}`",
				replace: "{rings.length}`",
				breaks: "the last ring of a whorl bears nothing",
			},
		],
	},
	{
		file: `${DESIGN}/templates/stem.gl3`,
		suites: ASSEMBLED,
		faults: [
			{
				id: "flower-stem-of-no-sides",
				find: " /* 3 … 24, of the stem */",
				replace: "",
				breaks: "the slider of a stem's sides goes to 0, and the flower to a mistake",
			},
		],
	},
	{
		file: `${DESIGN}/blade.ts`,
		suites: ASSEMBLED,
		faults: [
			{
				id: "flower-three-lobes-always",
				find: ".some(([, lobe]) => Number(lobe) > lobeCount)",
				replace: ".some(([, lobe]) => Number(lobe) > 3)",
				breaks: "petals as narrow as a thread have three lobes to a side",
			},
		],
	},
	{
		file: `${DESIGN}/merge.ts`,
		suites: MERGE,
		faults: [
			{
				id: "flower-choice-forgets-edits",
				find: "equalLines(generated, base)\n\t\t\t\t? edited",
				replace: "equalLines(generated, base)\n\t\t\t\t? base",
				breaks: "what was edited by hand goes with the next choice, and nobody is told",
			},
			{
				id: "flower-edits-lost-beside-choices",
				find: "NAME.exec(line)?.[0] ??",
				replace: "",
				breaks: "a number edited by hand goes where a choice changes the line above and how many there are",
			},
			{
				id: "flower-rules-lost-beside-choices",
				find: "areParallel(base, generated) ? 2 : areParallel(base, edited) ? 1 : undefined",
				replace: "areParallel(base, edited) ? 1 : undefined",
				breaks: "a production edited by hand goes where a choice changes the one above it",
			},
			{
				id: "flower-colours-lost-beside-choices",
				find: ": mergeWords([base, edited, generated]);",
				replace: ": undefined;",
				breaks: "a material's foot that was coloured by hand goes with the choice of its tip",
			},
		],
	},
	{
		file: `${VIEWS}/drafts.ts`,
		suites: [`${TESTS}/drafts.test.ts`],
		faults: [
			{
				id: "flower-choices-behind-values",
				find: "withText(grammar, specimen, text);",
				replace: "({ details: { grammar: text } });",
				breaks: "once a slider of Constants was moved, choices of the same number change nothing",
			},
			{
				id: "flower-values-lost-by-choices",
				find: "grownText(grammar, specimen, () => {})",
				replace: "fetchedText(specimen)",
				breaks: "the next choice takes back what sliders of Constants said",
			},
		],
	},
	{
		file: `${VIEWS}/elevation.ts`,
		suites: SCENES,
		faults: [
			{
				id: "flower-bends-away-from-the-hand",
				find: "bend: bend + degrees((8 * change)",
				replace: "bend: bend - degrees((8 * change)",
				breaks: "an organ bends outwards where its middle is taken so that it bends inwards",
			},
		],
	},
	{
		file: "web/src/models/flower/design/templates/stamen.gl3",
		suites: ["tests/web/models/flower/design/presets.test.ts"],
		faults: [
			{
				id: "design-stamens-unsewn",
				find: "#define FILAMENT(4,",
				replace: "#define FILAMENT(6,",
				breaks: "stamens of flowers by choices are sewn to nothing",
			},
		],
	},
];
