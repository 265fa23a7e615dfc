/** User guides: link targets, links to plants, and the parser of examples. */
const SUITES = ["tests/docs/pages.test.ts"];

export default [
	{
		file: "docs/for-teachers.md",
		suites: SUITES,
		faults: [
			{
				id: "docs-link-cut-short",
				find: "Write a link to the bunch of exercise 2. | `?v=2&procedure=paper&m=4&n=0,1,3`",
				replace: "Write a link to the bunch of exercise 2. | `?v=2&procedure=paper&m=4&n=0,1`",
				breaks: "the sheet's answer is another bunch than it says",
			},
			{
				id: "docs-anchor-gone",
				find: "(bunch.md#counts)",
				replace: "(bunch.md#count)",
				breaks: "the page leads to a heading that is not there",
			},
			{
				id: "docs-example-not-run",
				find: '```html title="sheet.html"',
				replace: '```html title="sheet.html" not-run',
				breaks: "an example stands that nobody has tried",
			},
		],
	},
	{
		file: "tests/docs/examples.ts",
		suites: SUITES,
		faults: [
			{
				id: "docs-anything-may-be-printed",
				find: 'line.trim() === "…" ?',
				replace: 'line.includes("…") ?',
				breaks: "lines with something that varies are not compared at all",
			},
		],
	},
];
