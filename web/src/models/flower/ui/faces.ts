/** Whether what stands on a face may be what a text lets grow there: of two in one line the faces tell which it is. */
import type { Piece } from "../../../grammar_editor/scan";

/**
 * `…]_{C1, C5}`: false where the faces have plain names and none of them is the one asked for.
 * @param behind the piece behind the list of what grows
 * @param face 0 O, 1 E, from 2 on C1 …; undefined where nobody knows
 */
export function canGrowOnFace(pieces: readonly Piece[], behind: number, face: number | undefined): boolean {
	if (face === undefined) return true;
	let at = behind;
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
	// One that is worked out, as C(1+step), may be any.
	const plain = named.length > 0 && (braced ? pieces[at]?.text === "}" : !/^[C(]$/.test(pieces[at]?.text ?? ""));
	return !plain || named.includes(face === 0 ? "O" : face === 1 ? "E" : `C${face - 1}`);
}
