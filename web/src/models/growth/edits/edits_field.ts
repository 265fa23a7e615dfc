/** Document field of edits of single branches: in links and files. */
import { fromBase64, toBase64 } from "../../../specimen/compressed_text";
import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { fieldOf, readNumber } from "../../../specimen/read_values";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import {
	type BranchEdit,
	cutShare,
	EDIT_KINDS,
	type EditKind,
	type EditPoint,
	editPoint,
	MAX_EDITS,
	MAX_POINTS,
} from "./branch_edit";

export const branchEdits: Field<GrowthSpecimen> = {
	keys: ["edit", "edits"],
	settings: ["edit=1.EDIT.EDIT.…"],
	fresh: () => ({ edits: [] }),
	read: (specimen, key, value, notes) => {
		specimen.edits = key === "edit" && typeof value === "string" ? readLink(value, notes) : readList(value, notes);
	},
	query: ({ edits }, preset) => {
		const written = writeLink(edits);
		return written === writeLink(preset.edits) ? [] : [["edit", written]];
	},
};

/** Version of the form in links, before the first edit. */
const VERSION = "1";
/** The letter of each kind in links. */
const LETTERS: Readonly<Record<EditKind, string>> = { prune: "p", break: "b", dead: "d", curve: "c" };
const ADDRESS_BYTES = 8;
const POINT_BYTES = 6;
const ADDRESS = /^[0-9a-f]{16}$/;

/**
 * Writes edits for a link: `1.p….d…`, a letter for the kind, then bytes in base64 for URLs: the address, the share of a
 * cut in hundredths, and the coordinates of points in centimetres, 16 bits each.
 */
export function writeLink(edits: readonly BranchEdit[]): string {
	return edits.length === 0
		? ""
		: [VERSION, ...edits.map((edit) => LETTERS[edit.kind] + toBase64(bytesOf(edit)))].join(".");
}

/** Returns the bytes of an edit in a link, after its letter. */
function bytesOf(edit: BranchEdit): Uint8Array {
	const points = edit.kind === "curve" ? edit.points : [];
	const cut = "at" in edit ? 1 : 0;
	const bytes = new Uint8Array(ADDRESS_BYTES + cut + POINT_BYTES * points.length);
	const view = new DataView(bytes.buffer);
	for (let i = 0; i < ADDRESS_BYTES; i++) bytes[i] = Number.parseInt(edit.shoot.slice(2 * i, 2 * i + 2), 16);
	if ("at" in edit) bytes[ADDRESS_BYTES] = Math.round(100 * edit.at);
	for (const [i, value] of points.flat().entries()) view.setInt16(ADDRESS_BYTES + 2 * i, Math.round(100 * value));
	return bytes;
}

/** Reads the edits of a link; unusable ones are left out and noted. */
function readLink(value: string, notes: Notes): readonly BranchEdit[] {
	if (value === "") return [];
	const [version, ...parts] = value.split(".", MAX_EDITS + 2);
	if (version !== VERSION) {
		notes.add("edit", text.message("edits_unreadable", { value: quote(value) }), text("edits_left_out"));
		return [];
	}
	return collect("edit", parts, fromLink, notes);
}

/** Reads the edits of a file; unusable ones are left out and noted. */
function readList(value: unknown, notes: Notes): readonly BranchEdit[] {
	if (Array.isArray(value)) return collect("edits", value, fromRecord, notes);
	notes.add("edits", text.message("edits_unreadable", { value: quote(value) }), text("edits_left_out"));
	return [];
}

/** Reads at most as many edits as a plant can have. */
function collect<T>(
	key: string,
	parts: readonly T[],
	read: (part: T) => BranchEdit | undefined,
	notes: Notes,
): readonly BranchEdit[] {
	const edits: BranchEdit[] = [];
	for (const part of parts.slice(0, MAX_EDITS)) {
		const edit = read(part);
		if (edit) edits.push(edit);
		else notes.add(key, text.message("edit_unreadable", { value: quote(part) }), text("edit_left_out"));
	}
	if (parts.length > MAX_EDITS)
		notes.add(key, text.message("too_many_edits", { most: MAX_EDITS }), text("first_edits_kept", { most: MAX_EDITS }));
	return edits;
}

/** Reads an edit of a link; undefined if it is damaged. */
function fromLink(part: string): BranchEdit | undefined {
	const kind = EDIT_KINDS.find((each) => LETTERS[each] === part[0]);
	const bytes = decode(part.slice(1));
	if (!kind || !bytes || bytes.length < ADDRESS_BYTES) return undefined;
	const shoot = [...bytes.subarray(0, ADDRESS_BYTES)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
	const rest = bytes.subarray(ADDRESS_BYTES);
	if (kind === "curve") {
		const view = new DataView(rest.buffer, rest.byteOffset, rest.byteLength);
		if (rest.length % POINT_BYTES !== 0) return undefined;
		const points = Array.from({ length: rest.length / POINT_BYTES }, (_, i) =>
			[0, 2, 4].map((k) => view.getInt16(POINT_BYTES * i + k) / 100),
		);
		return fromRecord({ shoot, kind, points });
	}
	if (kind === "dead") return rest.length === 0 ? { shoot, kind } : undefined;
	return rest.length === 1 ? fromRecord({ shoot, kind, at: rest[0] / 100 }) : undefined;
}

/** Reads an edit of a file; undefined if it has no such form. */
function fromRecord(record: unknown): BranchEdit | undefined {
	const shoot = fieldOf(record, "shoot");
	const kind = EDIT_KINDS.find((each) => each === fieldOf(record, "kind"));
	if (typeof shoot !== "string" || !ADDRESS.test(shoot) || !kind) return undefined;
	if (kind === "dead") return { shoot, kind };
	if (kind === "curve") {
		const points = readPoints(fieldOf(record, "points"));
		return points && { shoot, kind, points };
	}
	const at = readNumber(fieldOf(record, "at"));
	return at === undefined || !(at >= 0 && at <= 1) ? undefined : { shoot, kind, at: cutShare(at) };
}

/** Reads 1 to MAX_POINTS points; undefined if one of them is not three numbers. */
function readPoints(value: unknown): readonly EditPoint[] | undefined {
	if (!Array.isArray(value) || value.length === 0 || value.length > MAX_POINTS) return undefined;
	const points: EditPoint[] = [];
	for (const each of value) {
		const numbers = Array.isArray(each) ? each.map(readNumber) : [];
		const [x, y, z] = numbers;
		if (numbers.length !== 3 || x === undefined || y === undefined || z === undefined) return undefined;
		points.push(editPoint([x, y, z]));
	}
	return points;
}

/** Decodes base64 for URLs; undefined if it is damaged. */
function decode(code: string): Uint8Array | undefined {
	if (!/^[\w-]+$/.test(code)) return undefined;
	try {
		return fromBase64(code);
	} catch {
		return undefined;
	}
}
