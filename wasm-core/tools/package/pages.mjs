/** Writes the pages of docs/api from the comments on the exports of the package's entry points. */
import { readFileSync } from "node:fs";

/** Entry points, each with the example at the beginning of its page. */
const DOORS = {
	panicle: 'import { grow, toGLB } from "panicle";',
	three: 'import { toObject3D } from "panicle/three";',
	forest: 'import { Forest, GameTree } from "panicle/forest";',
	element: 'import "panicle/element";',
};

/** Methods that only browsers call: the callbacks of custom elements. */
const CALLBACK = /Callback$/;

/** Kinds of exports, in the order of a page. */
const SORTS = [
	["Functions", ["Function"]],
	["Classes", ["Class"]],
	["Types", ["Interface", "TypeAlias", "Variable"]],
];

/**
 * Returns the pages as texts, by the names of the entry points.
 * @param {Record<string, string>} models files that writeTypes has written
 */
export function pagesOf(models) {
	return Object.fromEntries(Object.entries(models).map(([door, file]) => [door, page(door, read(file))]));
}

const read = (file) => JSON.parse(readFileSync(file, "utf8")).members[0];

/**
 * Writes the page of an entry point: its summary, then its exports by kind.
 * @param door name of the entry point
 */
function page(door, { docComment, members }) {
	const title = door === "panicle" ? "panicle" : `panicle/${door}`;
	const begin = [
		`# ${title}`,
		"Made from the sources’ own comments by `npm run docs -- api`; how it is used is in [package.md](../package.md).",
	];
	const about = summaryOf(docComment);
	const known = new Set(members.map(({ name }) => name));
	const sections = SORTS.flatMap(([heading, kinds]) => {
		const chosen = members.filter(({ kind }) => kinds.includes(kind));
		return chosen.length > 0 ? [`## ${heading}`, ...chosen.map((each) => section(each, known))] : [];
	});
	return `${[...begin, `\`\`\`js\n${DOORS[door]}\n\`\`\``, ...(about ? [about] : []), ...sections].join("\n\n")}\n`;
}

/**
 * Writes the section of an export.
 * @param known names of the entry point's exports, to which texts link
 */
function section(member, known) {
	const { name, kind, docComment, members = [] } = member;
	const comment = commentOf(docComment);
	const blocks = [`### ${name}`];
	if (["Function", "TypeAlias", "Variable"].includes(kind)) blocks.push(code(signature(member)));
	if (comment.summary) blocks.push(comment.summary);
	blocks.push(...partsOf(member, comment));
	if (comment.returns) blocks.push(`Returns ${comment.returns}.`);
	if (comment.throws.length > 0)
		blocks.push(`Throws\n\n${comment.throws.map((each) => `- ${linked(each, known)}`).join("\n")}`);
	if (comment.example) blocks.push(comment.example);
	const rows = members.filter(
		(each) => each.kind !== "Constructor" && !CALLBACK.test(each.name) && !(kind === "Class" && each.name === "name"),
	);
	if (rows.length > 0)
		blocks.push(
			table(
				["", "", ""],
				rows.map((each) => [`\`${titleOf(each)}\``, cell(typeOf(each)), memberText(each)]),
			),
		);
	return blocks.join("\n\n");
}

/** Returns the table of the parameters that a comment explains, or nothing. */
function partsOf({ parameters = [] }, comment) {
	const explained = parameters.filter(({ parameterName }) => comment.params.has(parameterName));
	if (explained.length === 0) return [];
	return [
		table(
			["parameter", ""],
			explained.map(({ parameterName }) => [`\`${parameterName}\``, comment.params.get(parameterName)]),
		),
	];
}

const memberText = ({ docComment }) => commentOf(docComment).summary.replaceAll("|", "\\|");

function titleOf({ name, kind, isOptional }) {
	if (kind === "Method") return `${name}()`;
	return kind === "IndexSignature" ? "[key]" : `${name}${isOptional ? "?" : ""}`;
}

/** The type of a member; of a method, how it is called. */
function typeOf({ kind, excerptTokens, propertyTypeTokenRange }) {
	if (kind === "Method") return oneLine(excerptTokens);
	const { startIndex, endIndex } = propertyTypeTokenRange ?? { startIndex: 0, endIndex: 0 };
	return oneLine(excerptTokens.slice(startIndex, endIndex));
}

const signature = ({ excerptTokens }) =>
	excerptTokens
		.map(({ text }) => text)
		.join("")
		.replace(/^export declare /, "");
const oneLine = (tokens) =>
	tokens
		.map(({ text }) => text)
		.join("")
		.replace(/\s+/g, " ");
const code = (text) => `\`\`\`ts\n${text}\n\`\`\``;
const cell = (text) => (text ? `\`${text.replaceAll("|", "\\|")}\`` : "");

function table(heads, rows) {
	const line = (cells) => `| ${cells.join(" | ")} |`;
	return [line(heads), line(heads.map(() => "---")), ...rows.map(line)].join("\n");
}

/** Splits a comment by its tags. */
function commentOf(docComment = "") {
	const text = docComment
		.trim()
		.replace(/^\/\*\*|\*\/$/g, "")
		.split("\n")
		.map((line) => line.replace(/^\s*\* ?/, ""))
		.join("\n")
		.trim();
	const [summary, ...blocks] = text.split(/\n(?=@)|^(?=@)/);
	const tagged = blocks
		.map((block) => /^@(\w+)\s*([\s\S]*)$/.exec(block) ?? [])
		.map(([, tag, body]) => ({ tag, body: body.trim() }));
	const of = (tag) => tagged.filter((each) => each.tag === tag).map(({ body }) => body);
	const params = of("param").map((body) => /^(\w+)\s*-?\s*([\s\S]*)$/.exec(body) ?? []);
	return {
		summary: flat(summary),
		params: new Map(params.map(([, name, body]) => [name, flat(body)])),
		returns: flat(of("returns")[0] ?? ""),
		throws: of("throws").map(flat),
		example: of("example")[0] ?? "",
	};
}

/** A line for each paragraph. */
const flat = (text) =>
	text
		.split(/\n\s*\n/)
		.map((paragraph) => paragraph.replace(/\s*\n\s*/g, " ").trim())
		.join("\n\n");
const summaryOf = (docComment) => commentOf(docComment).summary;

/** Returns the text of a `@throws`, with its class as a link to the class's section. */
function linked(text, known) {
	return text.replace(/^\w+/, (name) => (known.has(name) ? `[${name}](#${name.toLowerCase()})` : name));
}
