/** Checks by a production's faces whether a volume may have grown by it. */
import type { Token } from "../../../grammar_editor/scan";

/**
 * Reads the faces on which a production places a volume, `[name(…){…}]_{C1, C5}`: O is the base, E the end, C1 … are the
 * sides. Returns false only if they are plain names and do not include `face`.
 * @param behindArguments index of the token behind the volume's argument list
 * @param face 0 O, 1 E, from 2 on C1 …; undefined if unknown
 */
export function canGrowOnFace(pieces: readonly Token[], behindArguments: number, face: number | undefined): boolean {
	if (face === undefined) return true;
	let at = behindArguments;
	// Skips the volume's own block.
	if (pieces[at]?.text === "{") while (at < pieces.length && pieces[at++].text !== "}");
	if (pieces[at++]?.text !== "]") return true;
	if (pieces[at]?.text === "_") at++;
	const braced = pieces[at]?.text === "{";
	if (braced) at++;
	const named: string[] = [];
	while (/^(?:[OE]|C\d+)$/.test(pieces[at]?.text ?? "")) {
		named.push(pieces[at++].text);
		if (pieces[at]?.text !== ",") break;
		at++;
	}
	// A computed face, as C(1+step), may be any.
	const plain = named.length > 0 && (braced ? pieces[at]?.text === "}" : !/^[C(]$/.test(pieces[at]?.text ?? ""));
	return !plain || named.includes(face === 0 ? "O" : face === 1 ? "E" : `C${face - 1}`);
}
