/** Renders the Markdown of docs/ for the documentation site as GitHub would, without any inline style or script. */
import { renderMermaidSVG } from "beautiful-mermaid";
import highlighter from "highlight.js";
import { anchorMaker } from "./anchors.mjs";

/** The code as HTML with classes; empty where the language is unknown: the code is shown as it is. */
const highlighted = (code, language) =>
	highlighter.getLanguage(language) ? highlighter.highlight(code, { language }).value : "";

/** A Mermaid diagram as SVG; site.css has the variables that its colours refer to. */
export function diagram(source) {
	const svg = renderMermaidSVG(source, { font: "system-ui" });
	const plain = svg.replace(/<style>[\s\S]*?<\/style>/g, "").replace(/ style="[^"]*"/g, "");
	const label = "Diagram; the table below lists the same folders";
	return `<div class="diagram" tabindex="0">${plain.replace("<svg ", `<svg role="img" aria-label="${label}" `)}</div>\n`;
}

/** Replaces the inline style that aligns a column, which the policy forbids, by a class. */
function alignByClass(token) {
	const [, side] = /^text-align:(\w+)$/.exec(token.attrGet("style") ?? "") ?? [];
	if (side) token.attrs = [["class", side]];
}

/**
 * @typedef {(address: string, file: string) => { address: string, title?: string } | undefined} Lead the address on the site for an
 *   address in a file of docs/, and the title of the page there; undefined where there is nothing to lead to
 */

/**
 * Translates a link. A link to nowhere becomes its text, and a link whose text is a file's name has the title of the
 * page.
 */
function leadLink(/** @type {any[]} */ tokens, start, file, /** @type {Lead} */ lead) {
	const end = tokens.findIndex(({ type }, index) => index > start && type === "link_close");
	const found = lead(tokens[start].attrGet("href") ?? "", file);
	if (!found) {
		for (const index of [start, end]) tokens[index] = Object.assign(tokens[index], { type: "text", content: "" });
		return;
	}
	tokens[start].attrSet("href", found.address);
	const text = tokens[start + 1];
	if (found.title && end === start + 2 && /^[\w/-]+\.md$/.test(text.content)) text.content = found.title;
}

/** Translates addresses of links and pictures; pictures are fetched when they come near the screen. */
function leadLinks(/** @type {any[]} */ tokens, file, /** @type {Lead} */ lead) {
	const to = (address) => lead(address, file)?.address ?? address;
	for (const [index, token] of tokens.entries()) {
		if (token.type === "link_open") leadLink(tokens, index, file, lead);
		if (token.type === "image") {
			token.attrSet("src", to(token.attrGet("src")));
			token.attrSet("loading", "lazy");
		}
		if (/^html_/.test(token.type)) {
			const changed = (_, name, address) => `${name}="${to(address)}"`;
			token.content = token.content.replace(/\b(src|href|poster)="([^"]*)"/g, changed);
			token.content = token.content.replaceAll("<img ", '<img loading="lazy" ');
		}
		leadLinks(token.children ?? [], file, lead);
	}
}

/**
 * Prepares Eleventy's markdown-it.
 *
 * @param {import("markdown-it").default} md
 * @param {Lead} lead
 */
export function prepareMarkdown(md, lead) {
	md.set({ html: true, linkify: false, highlight: highlighted });
	// Eleventy turns indented code off.
	md.enable("code");
	md.core.ruler.push("documentation-site", ({ tokens, env }) => {
		const anchor = anchorMaker();
		for (const [index, token] of tokens.entries()) {
			if (token.type === "heading_open") token.attrSet("id", anchor(tokens[index + 1].content));
			if (/^t[hd]_open$/.test(token.type)) alignByClass(token);
			// An empty cell is no heading of its column.
			if (token.type === "th_open" && tokens[index + 1].content === "")
				for (const tag of [token, tokens[index + 2]]) tag.tag = "td";
		}
		leadLinks(tokens, env.page.inputPath.replace(/^\.\//, ""), lead);
	});
	const { fence, table_open, table_close } = md.renderer.rules;
	md.renderer.rules.fence = (tokens, index, options, env, self) => {
		const { info, content } = tokens[index];
		if (info.trim() === "mermaid") return diagram(content);
		const [, title] = /\btitle="([^"]+)"/.exec(info) ?? [];
		const code = fence?.(tokens, index, options, env, self) ?? "";
		// Code that is wider than the page scrolls by keys, too.
		const block = code.replace("<pre>", '<pre tabindex="0">');
		return title ? `<figure><figcaption>${md.utils.escapeHtml(title)}</figcaption>${block}</figure>\n` : block;
	};
	md.renderer.rules.code_block = (tokens, index) =>
		`<pre tabindex="0"><code>${md.utils.escapeHtml(tokens[index].content)}</code></pre>\n`;
	md.renderer.rules.table_open = (...given) =>
		`<div class="table" tabindex="0">${table_open?.(...given) ?? given[4].renderToken(given[0], given[1], given[2])}`;
	md.renderer.rules.table_close = (...given) =>
		`${table_close?.(...given) ?? given[4].renderToken(given[0], given[1], given[2])}</div>\n`;
}
