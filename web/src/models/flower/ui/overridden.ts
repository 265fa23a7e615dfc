/** Which numbers of a volume's definition hold nowhere, since wherever one grows the text gives it others. */
import type { Piece } from "../../../grammar_editor/scan";
import { type Entry, entriesOf, inFields } from "./statements";

/**
 * By their places among N, T, atx, aty, atz, H, L, W, m. Of what grows on its like an empty place is that one's, and so says nothing of the
 * definition; where others take its name, or are split into it, all may hold.
 * @param statements those of its module, bare
 * @param translated whether its lists have a translation
 */
export function overridden(
	statements: readonly (readonly Piece[])[],
	label: string,
	translated: boolean | undefined,
): ReadonlySet<number> {
	const lists: (readonly (Entry | undefined)[])[] = [];
	for (const pieces of statements) {
		const arrow = pieces.findIndex(({ kind }) => kind === "arrow");
		const begins = /^#axiome?$/.test(pieces[0].text);
		if (arrow < 0 && !begins) continue;
		const same = !begins && predecessorOf(pieces, arrow) === label;
		for (let i = begins ? 1 : arrow + 1; i < pieces.length; i++) {
			if (pieces[i].text !== label) continue;
			if (begins || pieces[i - 1].text === "[") {
				if (!same) lists.push(listBehind(pieces, i, translated));
			} else if (!same || i > arrow + 1) return new Set();
		}
	}
	const fields = lists.length === 0 ? [] : [...lists[0].keys()];
	const gives = (list: readonly (Entry | undefined)[], field: number) => {
		const [from, to] = list[field] ?? [0, 0];
		return to > from;
	};
	return new Set(fields.filter((field) => lists.every((list) => gives(list, field))));
}

function listBehind(pieces: readonly Piece[], name: number, translated: boolean | undefined) {
	return pieces[name + 1]?.text === "(" ? inFields(entriesOf(pieces, name + 1).entries, translated) : [];
}

/** What stands before the blocks, or the arrow where there are none. */
function predecessorOf(pieces: readonly Piece[], arrow: number): string | undefined {
	const block = pieces.findIndex(({ text }) => text === "{");
	return pieces[(block >= 0 && block < arrow ? block : arrow) - 1]?.text;
}
