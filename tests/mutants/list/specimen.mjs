/** Specimens: links, files, history, and those of the bunch. */
const SRC = "web/src/specimen";
const TESTS = "tests/web/specimen";

export default [
	{
		file: `${SRC}/same.ts`,
		suites: [`${TESTS}/same.test.ts`],
		faults: [
			{
				id: "same-ignores-lists",
				find: "return [...new Set([...Object.keys(one), ...Object.keys(other)])].every(",
				replace:
					"if (Array.isArray(a)) return true;\n\treturn [...new Set([...Object.keys(one), ...Object.keys(other)])].every(",
				breaks: "bunches that differ in n or in what was thinned count as the same",
			},
			{
				id: "same-ignores-what-is-missing",
				find: "...Object.keys(one), ...Object.keys(other)",
				replace: "...Object.keys(one)",
				breaks: "an undo step is lost where only something was added",
			},
			{
				id: "same-colours-grow",
				find: "alike({ ...a, look: b.look }, b)",
				replace: "alike(a, b)",
				breaks: "a colour regrows the bunch",
			},
		],
	},
	{
		file: `${SRC}/altered_text.ts`,
		suites: [`${TESTS}/altered_text.test.ts`],
		faults: [
			{
				id: "text-dragged-loses-its-name",
				find: 'line.replace(NUMBER, "0")',
				replace: "line",
				breaks: "an oak whose handle was dragged is a grammar of one's own",
			},
			{
				id: "text-any-is-the-preset",
				find: "> SHARE * lines.length",
				replace: ">= 0",
				breaks: "a tree of another text is called an oak, altered",
			},
		],
	},
	{
		file: `${SRC}/link.ts`,
		suites: [`${TESTS}/link.test.ts`],
		faults: [
			{
				id: "link-query-of-any-length",
				find: "new URLSearchParams(search.slice(0, LONGEST_QUERY))) {",
				replace: "new URLSearchParams(search)) {",
				breaks: "a link of megabytes holds up the page",
			},
			{
				id: "link-length-unsaid",
				find: "if (search.length > LONGEST_QUERY)\n",
				replace: "if (search.length < 0)\n",
				breaks: "nothing says that a link was cut",
			},
			{
				id: "link-fragment-of-any-length",
				find: "if (hash.length > LONGEST_FRAGMENT) {",
				replace: "if (hash.length < 0) {",
				breaks: "half of a text is read without a word of it",
			},
			{
				id: "link-given-twice-unsaid",
				find: "if (values.has(key)) noteRepeated(key, notes);",
				replace: "",
				breaks: "of two values in a link one is dropped without a word",
			},
			{
				id: "link-seed-forgotten",
				find: "if (specimen.seed !== DEFAULT_SEED)",
				replace: "if (specimen.seed === DEFAULT_SEED)",
				breaks: "links bring another variation",
			},
		],
	},
	{
		file: `${SRC}/compressed_text.ts`,
		suites: [`${TESTS}/compressed_text.test.ts`, `${TESTS}/link.test.ts`],
		faults: [
			{
				id: "text-invalid-utf8-passes",
				find: 'new TextDecoder("utf-8", { fatal: true, ignoreBOM: true })',
				replace: 'new TextDecoder("utf-8", { ignoreBOM: true })',
				breaks: "a damaged grammar is read with question marks in it",
			},
			{
				id: "text-of-any-length",
				find: "if (length > longest) {",
				replace: "if (length < 0) {",
				breaks: "a few hostile bytes fill the memory",
			},
			{
				id: "text-base64-of-its-own",
				find: '.replaceAll("+", "-").replaceAll("/", "_")',
				replace: "",
				breaks: "copied links are cut at a + or /",
			},
		],
	},
	{
		file: `${SRC}/restore.ts`,
		suites: [`${TESTS}/restore.test.ts`],
		faults: [
			{
				id: "restore-preset-not-copied",
				find: "return structuredClone(base);",
				replace: "return base;",
				breaks: "a changed bunch changes its preset",
			},
			{
				id: "restore-unknown-keys-unsaid",
				find: 'else notes.add(key, text.message("unknown_key"), text("ignored"));',
				replace: "",
				breaks: "misspelt parameters are dropped without a word",
			},
			{
				id: "restore-older-links-as-now",
				find: "isOld ? 1 : SPECIMEN_VERSION",
				replace: "SPECIMEN_VERSION",
				breaks: "old links grow another bunch",
			},
		],
	},
	{
		file: `${SRC}/history.ts`,
		suites: [`${TESTS}/history.test.ts`],
		faults: [
			{
				id: "history-drag-loses-redo",
				find: "future: gesture === undefined ? [] : settled.future",
				replace: "future: []",
				breaks: "a drag that ends where it began loses what could be redone",
			},
			{
				id: "history-without-end",
				find: "settled.present].slice(-LONGEST_HISTORY)",
				replace: "settled.present]",
				breaks: "the history fills the memory",
			},
		],
	},
	{
		file: `${SRC}/limits.ts`,
		suites: [`${TESTS}/restore.test.ts`, `${TESTS}/link.test.ts`],
		faults: [
			{
				id: "grammar-bytes-as-letters",
				find: "return lengthProblem(grammar.length) ?? lengthProblem(new TextEncoder().encode(grammar).length);",
				replace: "return lengthProblem(grammar.length);",
				breaks: "a long grammar of accented letters is refused by the core only",
			},
		],
	},
	{
		file: "web/src/models/bunch/measures.ts",
		suites: ["tests/web/models/bunch/measures.test.ts"],
		faults: [
			{
				id: "lab-wrong-matrix",
				find: "0.3575761 * g + 0.1804375 * b) / 0.95047",
				replace: "0.3575761 * b + 0.1804375 * g) / 0.95047",
				breaks: "skins are classed as colours they are not",
			},
		],
	},
	{
		file: "web/src/models/bunch/details/thinned.ts",
		suites: [`${TESTS}/link.test.ts`, `${TESTS}/restore.test.ts`, "tests/web/models/bunch/ui/thinning.test.ts"],
		faults: [
			{
				id: "thinned-unlimited",
				find: "if (thinned.includes(id) || thinned.length >= MAX_THINNED) return specimen;",
				replace: "if (thinned.includes(id)) return specimen;",
				breaks: "links become longer than address bars take",
			},
			{
				id: "thinned-any-id",
				find: "&& id >= 0 && id < BERRY_IDS",
				replace: "&& id >= 0",
				breaks: "ids that no berry can have are sent to the core",
			},
		],
	},
	{
		file: "web/src/models/bunch/details/inputs.ts",
		suites: [`${TESTS}/restore.test.ts`, `${TESTS}/link.test.ts`],
		faults: [
			{
				id: "inputs-n-of-any-length",
				find: "else if (n.length !== m - 1) {",
				replace: "else if (n.length < 0) {",
				breaks: "n of another length than m wants is sent to the core, which refuses it",
			},
		],
	},
	{
		file: "web/src/models/bunch/request.ts",
		suites: ["tests/web/models/bunch/request.test.ts"],
		faults: [
			{
				id: "request-overrules-the-text",
				find: "entry.define !== undefined && number === entry.default ? Number.NaN : number",
				replace: "number",
				breaks: "a person's own #define is overruled by sliders that nobody moved",
			},
			{
				id: "request-all-in-passing",
				find: "sky = meshes && !preview",
				replace: "sky = meshes",
				breaks: "every step of a drag surveys the sky, a fifth of what it costs",
			},
			{
				id: "request-thinned-forgotten",
				find: '{ name: "thinned", data: wholeNumbers("thinned", thinned) },',
				replace: '{ name: "thinned", data: wholeNumbers("thinned", []) },',
				breaks: "berries that were taken off grow back",
			},
		],
	},
];
