/**
 * Sections of documentation pages that programs write: the text between `<!-- NAME: begin -->` and `<!-- NAME: end
 * -->`.
 */

/**
 * The page with the section's text replaced.
 * @param {string} page
 * @param {string} name of the section
 * @param {string} text the section's new text, in Markdown
 * @throws Error where the page lacks the markers
 */
export function replaceSection(page, name, text) {
	const [begin, end] = [`<!-- ${name}: begin -->`, `<!-- ${name}: end -->`];
	const [from, to] = [page.indexOf(begin), page.indexOf(end)];
	if (from < 0 || to < from) throw new Error(`A page of documentation lacks ${begin} or ${end}.`);
	return `${page.slice(0, from)}${begin}\n\n${text.trim()}\n\n${page.slice(to)}`;
}
