/**
 * Finds numbers of a volume's definition that have no effect, since every production that grows the volume overrides
 * them.
 */
import type { Token } from "../../../grammar_editor/scan";
import { entriesOf, type FlowerEntry, inFields } from "./statements";

/**
 * Returns the overridden numbers as indices into N, T, atx, aty, atz, H, L, W, m. Productions whose predecessor has
 * the same label do not count: empty entries there take the predecessor's values. Where volumes are relabelled or
 * split into this one, none counts as overridden.
 * @param statements the module's statements, without comments
 * @param translated whether the volume's lists have a translation
 */
export function overridden(
	statements: readonly (readonly Token[])[],
	label: string,
	translated: boolean | undefined,
): ReadonlySet<number> {
	const lists: (readonly (FlowerEntry | undefined)[])[] = [];
	for (const pieces of statements) {
		const arrow = pieces.findIndex(({ kind }) => kind === "arrow");
		const isAxiom = /^#axiome?$/.test(pieces[0].text);
		if (arrow < 0 && !isAxiom) continue;
		const sameLabel = !isAxiom && predecessorOf(pieces, arrow) === label;
		for (let i = isAxiom ? 1 : arrow + 1; i < pieces.length; i++) {
			if (pieces[i].text !== label) continue;
			if (isAxiom || pieces[i - 1].text === "[") {
				if (!sameLabel) lists.push(listAfter(pieces, i, translated));
			} else if (!sameLabel || i > arrow + 1) return new Set();
		}
	}
	const fields = lists.length === 0 ? [] : [...lists[0].keys()];
	const isSet = (list: readonly (FlowerEntry | undefined)[], field: number) => {
		const [from, to] = list[field] ?? [0, 0];
		return to > from;
	};
	return new Set(fields.filter((field) => lists.every((list) => isSet(list, field))));
}

/** Returns the entries of the list after a volume's name, by field; none if there is no list. */
function listAfter(pieces: readonly Token[], name: number, translated: boolean | undefined) {
	return pieces[name + 1]?.text === "(" ? inFields(entriesOf(pieces, name + 1).entries, translated) : [];
}

/** Returns the name before the blocks, or before the arrow if there are no blocks. */
function predecessorOf(pieces: readonly Token[], arrow: number): string | undefined {
	const block = pieces.findIndex(({ text }) => text === "{");
	return pieces[(block >= 0 && block < arrow ? block : arrow) - 1]?.text;
}
