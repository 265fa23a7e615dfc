/**
 * Document fields of the paper's grammar inputs, in place of those computed from the profile: m rachis segments, n₁ …
 * n₍m−1₎.
 */

import type { Field } from "../../../specimen/model_schema";
import { type Notes, quote } from "../../../specimen/notes";
import { readList, readNumbers } from "../../../specimen/read_values";
import { readWithin } from "../../../specimen/read_within";
import { text } from "../messages.generated";
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

/** Reads `m`, or the list of `n`; values out of range are replaced, with a note. */
function readInput(specimen: BunchSpecimen, key: string, value: unknown, notes: Notes): void {
	if (key === "m") {
		const m = readWithin(INPUT_M, key, value, text("profile_value_used"), notes);
		if (m !== undefined) specimen.inputs = { ...specimen.inputs, m };
		return;
	}
	const values = readList(value);
	const n = readNumbers(values.slice(0, INPUT_N_LENGTH));
	if (!n || n.length === 0) {
		notes.add(key, text.message("not_a_list", { value: quote(value) }), text("profile_values_used"));
		return;
	}
	if (values.length > n.length) {
		notes.add(
			key,
			text.message("too_many_values", { count: values.length }),
			text("first_values_used", { count: n.length }),
		);
	}
	specimen.inputs = {
		...specimen.inputs,
		n: n.map((each) => readWithin(INPUT_N, key, each, text("zero_used"), notes) ?? 0),
	};
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
			text.message("wrong_number_of_values", { m, needed: m - 1, given: n.length }),
			text("profile_values_used"),
		);
		specimen.inputs = { m };
	}
}
