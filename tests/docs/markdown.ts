/** Links of a Markdown file, and its anchors. */

export interface Target {
	/** As it is written, without the anchor; empty: the same file. */
	readonly path: string;
	readonly anchor: string;
}

/** Files that a text leads to or shows, by relative addresses. */
export function targetsOf(text: string): Target[] {
	const prose = text.replace(/^```[\s\S]*?^```$/gm, "").replace(/`[^`\n]*`/g, "");
	const written = [...prose.matchAll(/\]\(([^)\s]+)(?:\s"[^"]*")?\)|(?:src|href)="([^"]+)"/g)].map(
		([, link, tag]) => link ?? tag,
	);
	return written
		.filter((address) => !/^[a-z]+:/i.test(address))
		.map((address) => {
			const [path, anchor = ""] = address.split("#");
			return { path, anchor };
		});
}

/** Anchors of a text's headings, as GitHub makes them. */
export function anchorsOf(text: string): Set<string> {
	const anchors = new Set<string>();
	for (const [, heading] of text.replace(/^```[\s\S]*?^```$/gm, "").matchAll(/^#{1,6} +(.*?) *$/gm)) {
		const plain = heading.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").toLowerCase();
		const slug = plain.replace(/[^\p{L}\p{N}\p{M}_ -]/gu, "").replaceAll(" ", "-");
		let anchor = slug;
		for (let again = 1; anchors.has(anchor); again++) anchor = `${slug}-${again}`;
		anchors.add(anchor);
	}
	return anchors;
}
