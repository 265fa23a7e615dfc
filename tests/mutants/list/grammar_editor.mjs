/** The editor of grammars, its sliders and curves. */
const SRC = "web/src/grammar_editor";
const TESTS = "tests/web/grammar_editor";

export default [
	{
		file: `${SRC}/outline.ts`,
		suites: [`${TESTS}/outline.test.ts`],
		faults: [
			{
				id: "grammar-editor-operator-taken-for-a-sign",
				find: "(!endsValue || isDefined(pieces, index - 2))",
				replace: "true",
				breaks: "dragging the 2 of x-2 rewrites the minus",
			},
			{
				id: "grammar-editor-half-an-expression",
				find: '(open <= 0 && last !== "<")',
				replace: "true",
				breaks: "a value is written over the first line of what it stands for, and the file is no grammar",
			},
			{
				id: "grammar-editor-constant-outside-its-slider",
				find: "const ends = [readSigned(low), readSigned(high), value];",
				replace: "const ends = [readSigned(low), readSigned(high)];",
				breaks: "a slider jumps when it is touched, where the text's number lies beyond the comment's range",
			},
		],
	},
	{
		file: `${SRC}/scrub.ts`,
		suites: [`${TESTS}/direct_editing.test.ts`],
		faults: [
			{
				id: "grammar-editor-digits-lost",
				find: "return written(moved, places + (finer ? 1 : 0));",
				replace: "return String(moved);",
				breaks: "a dragged number is written with seventeen digits",
			},
		],
	},
	{
		file: `${SRC}/read_outline.ts`,
		suites: [`${TESTS}/words.test.ts`],
		faults: [
			{
				id: "grammar-editor-scans-each-time",
				find: "const known = recent.find(",
				replace: "const known = [].find(",
				breaks: "each key scans the whole text four times",
			},
		],
	},
	{
		file: `${SRC}/highlight.ts`,
		suites: [`${TESTS}/words.test.ts`],
		faults: [
			{
				id: "grammar-editor-colours-long-lines",
				find: "line.length > LONGEST_COLOURED",
				replace: "line.length < 0",
				breaks: "a line of 248 KB puts 14,000 elements into the page, laid out anew at each key",
			},
		],
	},
	{
		file: `${SRC}/curve_editor.ts`,
		suites: ["tests/e2e/long_texts.spec.ts: a curve of thousands"],
		faults: [
			{
				id: "grammar-editor-handle-for-each-point",
				find: "points.length <= MAX_POINTS",
				replace: "true",
				breaks: "a curve of 50,000 points puts 50,000 handles into the page",
			},
		],
	},
	{
		file: `${SRC}/curve.ts`,
		suites: [`${TESTS}/direct_editing.test.ts`],
		faults: [
			{
				id: "grammar-editor-curve-points-cross",
				find: "points[moving + 1][0] - gap : right",
				replace: "right : right",
				breaks: "a point is dragged past the next, and the text is no curve",
			},
		],
	},
	{
		file: `${SRC}/source.ts`,
		suites: [`${TESTS}/direct_editing.test.ts`],
		faults: [
			{
				id: "grammar-editor-built-in-text-of-its-own",
				find: "text === builtIn ? undefined : text",
				replace: "text",
				breaks: "after Undo by hand a bunch keeps a copy of the built-in text in its link",
			},
		],
	},
	{
		file: `${SRC}/grammar_pane.ts`,
		suites: ["tests/e2e/editor.spec.ts"],
		faults: [
			{
				id: "grammar-editor-errors-unmarked",
				find: "this.#editor.problems = this.#problems;",
				replace: "",
				breaks: "mistakes are listed but not marked in the text",
			},
		],
	},
	{
		file: `${SRC}/editor.ts`,
		suites: ["tests/e2e/editor_find.spec.ts: words are found"],
		faults: [
			{
				id: "grammar-editor-search-unknown",
				find: "\t\t\t\t\tfinding(),\n",
				replace: "",
				breaks: "Ctrl and F opens nothing",
			},
		],
	},
	{
		file: `${SRC}/typing_room.ts`,
		suites: ["tests/e2e/editor_find.spec.ts: the keyboard covers no line"],
		faults: [
			{
				id: "grammar-editor-under-the-keyboard",
				find: 'root.toggleAttribute("data-keyboard", now);',
				replace: "",
				breaks: "a phone's keyboard covers the line that is typed in",
			},
		],
	},
	{
		file: `${SRC}/grammar_pane.ts`,
		suites: ["tests/e2e/trouble.spec.ts: what takes long to grow from a text"],
		faults: [
			{
				id: "grammar-editor-escape-leaves-what-grows",
				find: "if (this.context.state.growing) this.context.cancel();\n\t\telse",
				replace: "",
				breaks: "Escape in the text leaves it while a million modules go on growing",
			},
			{
				id: "grammar-editor-next-character-waits",
				find: "if (context.state.growing) context.cancel();",
				replace: "",
				breaks: "the next character waits until a million modules of the text before have grown",
			},
		],
	},
	{
		file: "web/src/grammar_editor/range_words.ts",
		suites: ["tests/web/grammar_editor/range_words.test.ts"],
		faults: [
			{
				id: "range-words-dots-of-numbers",
				find: 'text[whole] === "." && text[whole + 1] !== "."',
				replace: 'text[whole] === "."',
				breaks: "a comment that says 0..90 gives its slider no range",
			},
			{
				id: "range-words-looked-at-again",
				find: "at = separated ?? lowEnd;",
				replace: "at++;",
				suites: ["tests/web/hostile_texts.test.ts"],
				breaks: "a link with a long number in a comment hangs the page",
				hangs: true,
			},
		],
	},
	{
		file: "web/src/grammar_editor/comments.ts",
		suites: ["tests/patterns.test.ts"],
		faults: [
			{
				id: "comments-never-closed-hang",
				find: "(?:\\*\\/|$)/g, blanked)",
				replace: "\\*\\//g, blanked)",
				breaks: "a text of many comments that are never closed hangs the page",
			},
		],
	},
	{
		file: "web/src/specimen/read_values.ts",
		suites: ["tests/patterns.test.ts"],
		faults: [
			{
				id: "numbers-backtrack",
				find: "\\d+(?:\\.\\d*)?|",
				replace: "\\d+\\.?\\d*|",
				breaks: "a file with a long number that is none hangs the page",
			},
		],
	},
	{
		file: "web/src/models/growth/volumes/footprint.ts",
		suites: ["tests/web/hostile_texts.test.ts"],
		faults: [
			{
				id: "footprints-in-footprints",
				find: "if (head.index < (footprints.at(-1)?.end ?? 0)) continue;",
				replace: "",
				breaks: "a text of many volumes that are never closed hangs the page",
				hangs: true,
			},
		],
	},
	{
		file: "web/src/batch/csv_rows.ts",
		suites: ["tests/web/hostile_texts.test.ts"],
		faults: [
			{
				id: "csv-rows-within-quotes",
				find: 'else if (!isQuoted && text[at] === "\\n") {',
				replace: 'else if (text[at] === "\\n") {',
				breaks: "a series goes on from a table whose notes have lines as if plants were missing",
			},
		],
	},
];
