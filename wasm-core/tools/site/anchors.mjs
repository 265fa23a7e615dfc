/** Anchors of headings, as GitHub makes them: links to headings work there and on the documentation site. */

/** The anchor of a heading's Markdown text, without the number that distinguishes equal headings of a page. */
function slugOf(heading) {
	const plain = heading.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").toLowerCase();
	return plain.replace(/[^\p{L}\p{N}\p{M}_ -]/gu, "").replaceAll(" ", "-");
}

/**
 * Returns a function that gives each heading of a page its anchor, in the order of the page.
 * @returns {(heading: string) => string}
 */
export function anchorMaker() {
	const made = new Set();
	return (heading) => {
		const slug = slugOf(heading);
		let anchor = slug;
		for (let again = 1; made.has(anchor); again++) anchor = `${slug}-${again}`;
		made.add(anchor);
		return anchor;
	};
}
