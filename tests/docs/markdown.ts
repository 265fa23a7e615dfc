/** Links of a Markdown file, and its anchors. */
import { anchorMaker } from "../../wasm-core/tools/site/anchors.mjs";

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
	const anchor = anchorMaker();
	const headings = text.replace(/^```[\s\S]*?^```$/gm, "").matchAll(/^#{1,6} +(.*?) *$/gm);
	return new Set([...headings].map(([, heading]) => anchor(heading)));
}
