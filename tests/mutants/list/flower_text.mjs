/** Flowers' texts: which are known as such, read as statements, as XML. */
export default [
	{
		file: "web/src/models/flower/ui/statements.ts",
		suites: ["tests/web/models/flower/xml.test.ts", "tests/web/models/flower/token_edits.test.ts"],
		faults: [
			{
				id: "flower-xml-short-lists",
				find: "hasTranslation ? withoutExtra : [withoutExtra[0], undefined, ...withoutExtra.slice(1)]",
				replace: "withoutExtra",
				breaks: "lists without a translation are shifted in XML",
			},
			{
				id: "flower-ten-figures",
				find: ".filter((_, i) => entries.length !== 10 || i !== 5)",
				replace: "",
				breaks: "the height of a volume of ten numbers is shown as 0, and moving it writes what the core passes over",
			},
			{
				id: "flower-statements-without-blanks",
				find: "{ ...piece, text: wordOf(piece) }",
				replace: "piece",
				breaks: "a text with # define is another flower as XML",
			},
			{
				id: "flower-statements-without-comments-within",
				find: 'before?.text === "#" &&',
				replace: 'before?.text === "##" &&',
				breaks: "a text with a comment behind a sign is another flower as XML",
			},
		],
	},
	{
		file: "web/src/models/flower/schema.ts",
		suites: ["tests/web/models/flower/claims.test.ts"],
		faults: [
			{
				id: "flower-axiom-without-blanks",
				find: "/^[ \\t]*#[ \\t]*axiome?\\b/m",
				replace: "/^[ \\t]*#axiome?\\b/m",
				breaks: "a flower with # axiom is taken for an L-system",
			},
			{
				id: "flower-without-growth",
				find: "(?:[OE]|C\\d+)[ \\t]*(?:--?>|→)/,",
				replace: "(?:[O]|C\\d+)[ \\t]*(?:-->|→)/,",
				breaks: "a flower whose volumes are halved alone is taken for an L-system",
			},
			{
				id: "flower-of-any-numbers",
				find: "AXIOM.test(text) && OWN",
				replace: "OWN",
				breaks: "an L-system whose branch ends before an E is taken for a flower",
			},
			{
				id: "flower-misspelt-face",
				find: "/\\]\\s*(?:_|",
				replace: "/\\]\\s*(?:",
				breaks: "a flower whose only face is misspelt is told about L-systems",
			},
		],
	},
	{
		file: "web/src/cli/requested_specimen.ts",
		suites: ["tests/web/cli/grammar.test.ts"],
		faults: [
			{
				id: "flower-xml-lines-of-the-text",
				find: "textName: grammar === contents ? file :",
				replace: "textName: grammar !== undefined ? file :",
				breaks: "mistakes in a text that XML became are told with lines that the XML does not have",
			},
		],
	},
	{
		file: "web/src/specimen/limits.ts",
		suites: ["tests/web/app/open.test.ts"],
		faults: [
			{
				id: "flower-xml-as-short-as-text",
				find: "? XML_BYTES : GRAMMAR_BYTES",
				replace: "? GRAMMAR_BYTES : GRAMMAR_BYTES",
				breaks: "XML that was written of a long text is not read again",
			},
		],
	},
	{
		file: "web/src/models/flower/xml/elements.ts",
		suites: ["tests/web/models/flower/xml.test.ts"],
		faults: [
			{
				id: "flower-xml-document-type",
				find: '} else if (this.#startsWith("<!")) {',
				replace: '} else if (this.#startsWith("<!") && false) {',
				breaks: "a document type is no mistake of its own",
			},
		],
	},
];
