/** Flowers in the page: rendering, reading, writing and requests. */
export default [
	{
		file: "web/src/models/flower/flower_plant.ts",
		suites: ["tests/web/models/flower/paint.test.ts"],
		faults: [
			{
				id: "flower-names-of-other-parts",
				find: 'columns.text("materials.name").split("\\n")',
				replace: 'columns.lines("materials.name")',
				breaks: "where some materials have no name, parts are called what others are",
			},
		],
	},
	{
		file: "web/src/models/flower/paint.ts",
		suites: ["tests/web/models/flower/paint.test.ts"],
		faults: [
			{
				id: "flower-no-veins",
				find: "return veins.count >= 1\n\t\t? mixed(withMargin",
				replace: "return veins.count >= 99\n\t\t? mixed(withMargin",
				breaks: "petals have no veins",
			},
			{
				id: "flower-feathers-across",
				find: "(u - FORWARD * v * (1 + 0.5 * v))",
				replace: "u",
				breaks: "side veins of a leaf stand at right angles to its rib",
			},
		],
	},
	{
		file: "web/src/models/flower/ui/chosen_volume.ts",
		suites: ["tests/web/models/flower/chosen_volume.test.ts"],
		faults: [
			{
				id: "flower-children-behind-their-parents",
				find: "const parentOrCount = Math.min(parent[volume], count);",
				replace: "const parentOrCount = parent[volume] > volume ? count : parent[volume];",
				breaks: "where a text splits, another volume is chosen than was clicked on",
			},
		],
	},
	{
		file: "web/src/models/flower/ui/token_edits.ts",
		suites: ["tests/web/models/flower/token_edits.test.ts"],
		faults: [
			{
				id: "flower-dead-sliders",
				find: ".filter(({ name }) => !setByCalls.has(name))",
				replace: "",
				breaks: "a chosen volume has sliders of variables that every call sets, which move nothing",
			},
			{
				id: "flower-dead-figures-of-definitions",
				find: ".filter(({ name }) => !overriddenFields.has(FIELDS.indexOf(name))),",
				replace: ",",
				breaks: "a chosen volume has sliders of a definition's figures that every growth gives otherwise",
			},
			{
				id: "flower-figures-of-another-module",
				find: "const end = modules[module + 1]?.at ?? pieces.length;",
				replace: "const end = pieces.length;",
				breaks: "a click shows the figures of other modules' volumes of the same name",
			},
			{
				id: "flower-figures-of-the-first-call",
				find: "return found.length > 0 ? found : lists;",
				replace: "return found.slice(0, 1);",
				breaks: "of two calls of a module on one line the second's volumes show the first's figures",
			},
		],
	},
	{
		file: "web/src/models/flower/ui/number_range.ts",
		suites: ["tests/web/models/flower/token_edits.test.ts"],
		faults: [
			{
				id: "flower-counts-from-nothing",
				find: "-limit : Number(isWhole), limit",
				replace: "-limit : 0, limit",
				breaks: "a chosen volume's slider of its module's steps goes to 0, by which it is divided",
			},
		],
	},
	{
		file: "wasm-core/grammars/flower/rose.gl3",
		suites: ["tests/web/models/flower/species.test.ts"],
		faults: [
			{
				id: "flower-rose-of-many-leaflets",
				find: "-> SPENT[RACHIS(",
				replace: "-> RACHIS[RACHIS(",
				breaks: "a rose's leaf has nineteen leaflets",
			},
		],
	},
	{
		file: "wasm-core/grammars/flower/crocus.gl3",
		suites: ["tests/web/models/flower/species.test.ts"],
		faults: [
			{
				id: "flower-crocus-of-many-leaves",
				find: "-> GROWN[SHEATH(",
				replace: "-> SHEATH[SHEATH(",
				breaks: "a crocus has up to ten leaves",
			},
		],
	},
	{
		file: "web/src/grammar_editor/source.ts",
		suites: ["tests/web/models/flower/values.test.ts"],
		faults: [
			{
				id: "flower-slider-brings-a-text",
				find: "if (!presetConstants || isOwn(specimen))",
				replace: "if (true)",
				breaks: "one slider of a preset puts its whole text into the link",
			},
			{
				id: "flower-value-twice",
				find: ".filter(([name]) => !defined.has(name))",
				replace: "",
				breaks: "a number of the text that is edited stays what a slider said before",
			},
		],
	},
	{
		file: "web/src/models/flower/ui/text.ts",
		suites: ["tests/web/models/flower/values.test.ts"],
		faults: [
			{
				id: "flower-final-step-as-a-variable",
				find: 'governed: new Set(["finalStep"])',
				replace: "governed: new Set()",
				breaks: "a slider finalStep changes nothing but the text that is shown",
			},
		],
	},
	{
		file: "web/src/models/flower/request.ts",
		suites: ["tests/web/models/flower/values.test.ts"],
		faults: [
			{
				id: "flower-values-stay-at-home",
				find: "names.length === 0",
				replace: "true",
				breaks: "values of the link change nothing",
			},
		],
	},
	{
		file: "web/src/models/flower/request.ts",
		suites: ["tests/web/models/flower/grown.test.ts"],
		faults: [
			{
				id: "flower-document-without-surface",
				find: "(meshes || measures) &&",
				replace: "meshes &&",
				breaks: "a flower's JSON has no surface and counts no triangles",
			},
		],
	},
	{
		file: "web/src/models/flower/record.ts",
		suites: ["tests/web/models/flower/values.test.ts"],
		faults: [
			{
				id: "flower-any-map-is-sent",
				find: "if (count <= MAX_DARTS) return undefined;",
				replace: "return undefined;",
				breaks: "a text of a few lines has a server send 300 MB",
			},
		],
	},
	{
		file: "web/src/models/flower/texts.ts",
		suites: ["tests/web/models/flower/age.test.ts"],
		faults: [
			{
				id: "flower-life-of-texts-without-one",
				find: "text === undefined || isOfAge(uncommented(text))",
				replace: "true",
				breaks: "a life is offered to be played in which nothing happens",
			},
		],
	},
	{
		file: "web/src/models/flower/ui/organ.ts",
		suites: ["tests/web/models/flower/organ.test.ts"],
		faults: [
			{
				id: "organ-of-any-call",
				find: "states[root] = WITHIN;",
				replace: "states.fill(WITHIN);",
				breaks: "a click on a petal lights up the whole flower",
			},
			{
				id: "organ-without-its-kind",
				find: 'name === "" || name.includes(",") || name.includes(kind)',
				replace: "true",
				breaks: "a click on a petal says “Upper epidermis”, and nobody knows of what",
			},
		],
	},
];
