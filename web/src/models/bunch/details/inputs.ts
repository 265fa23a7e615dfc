/**
 * Document fields of the paper's grammar inputs, in place of those computed from the profile: m rachis segments, n₁ …
 * n₍m−1₎.
 */

import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { readList, readNumbers } from "../../../specimen/read_values";
import { readWithin } from "../../../specimen/read_within";
import type { BunchSpecimen } from "../specimen";

/** Ranges of the number of rachis segments, and of segments of each first-order axis. */
const INPUT_M = { kind: "integer", min: 1, max: 100 } as const;
const INPUT_N = { kind: "integer", min: 0, max: 100 } as const;
/** Most values of `n`: n₁ … n₍m−1₎ of the longest rachis. */
export const INPUT_N_LENGTH = INPUT_M.max - 1;

export const grammarInputs: Field<BunchSpecimen> = {
	keys: ["m", "n"],
	settings: ["m", "n=N1,N2,…"],
	group: "inputs",
	where: { procedure: "paper" },
	read: readInput,
	agree: matchInputs,
	query: ({ inputs: { m, n } = {} }) => [
		...(m === undefined ? [] : [["m", String(m)] as const]),
		...(n === undefined ? [] : [["n", n.join(",")] as const]),
	],
};

function readInput(specimen: BunchSpecimen, key: string, value: unknown, notes: Notes): void {
	if (key === "m") {
		const m = readWithin(INPUT_M, key, value, "the profile's", notes);
		if (m !== undefined) specimen.inputs = { ...specimen.inputs, m };
		return;
	}
	const given = readList(value);
	const n = readNumbers(given.slice(0, INPUT_N_LENGTH));
	if (!n || n.length === 0) {
		notes.add(key, `${quote(value)} is not a list of numbers like “1,2”`, "the profile's is used");
		return;
	}
	if (given.length > n.length) notes.add(key, `${given.length} values are too many`, `the first ${n.length} are used`);
	specimen.inputs = { ...specimen.inputs, n: n.map((each) => readWithin(INPUT_N, key, each, 0, notes) ?? 0) };
}

/**
 * Makes m and n agree, since the grammar reads n₁ … n₍m−1₎: `n` alone determines m, and an `n` of another length than
 * m requires is dropped.
 */
function matchInputs(specimen: BunchSpecimen, notes: Notes): void {
	const { m, n } = specimen.inputs ?? {};
	if (!n) return;
	if (m === undefined) specimen.inputs = { m: n.length + 1, n };
	else if (n.length !== m - 1) {
		notes.add(
			"n",
			`m = ${m} needs ${m - 1} ${m === 2 ? "value" : "values"}, not ${n.length}`,
			"the profile's are used",
		);
		specimen.inputs = { m };
	}
}
