/** Results of the mutants, as a table by kind and a line for each problem. */
import { KINDS } from "./mutants.mjs";

/**
 * @typedef {object} Result
 * @property {string} key identifies the state that was tested (mutants.mjs)
 * @property {"caught" | "survived" | "invalid" | "slow"} outcome invalid: it does not compile; slow: a suite did not end
 * @property {string} [by] the suite that noticed
 * @property {string} [why] the reason of an invalid one
 * @property {number} seconds
 */

const COLUMNS = ["caught", "survived", "invalid", "slow", "not run"];

/** Least share of detected mutants. */
export const ENOUGH = 0.95;

const outcomeOf = (result) => result?.outcome ?? "not run";

function row(name, some, results) {
	const counts = COLUMNS.map((column) => some.filter(({ id }) => outcomeOf(results.get(id)) === column).length);
	const seconds = some.reduce((sum, { id }) => sum + (results.get(id)?.seconds ?? 0), 0);
	return [name, some.length, ...counts, `${Math.round(seconds)} s`];
}

/** Problems that need action, one line each. */
export function complaints(mutants, results) {
	return mutants.flatMap(({ id, file, breaks, survives }) => {
		const result = results.get(id);
		const outcome = outcomeOf(result);
		if (outcome === "survived" && !survives) return [`${id} survives (${file}): ${breaks}`];
		if (outcome === "caught" && survives)
			return [`${id} is caught by now, by ${result.by}: take its reason out of the list`];
		if (outcome === "invalid") return [`${id} does not compile: ${result.why}`];
		if (outcome === "slow") return [`${id}: a suite did not end; is it one that hangs?`];
		return [];
	});
}

/** Of those that have run, the share that was caught; 1 where none has. */
export function shareCaught(mutants, results) {
	const ran = mutants.filter(({ id }) => ["caught", "survived"].includes(outcomeOf(results.get(id))));
	return ran.length === 0 ? 1 : ran.filter(({ id }) => results.get(id).outcome === "caught").length / ran.length;
}

/** @param {import("./mutants.mjs").Mutant[]} mutants @param {Map<string, Result>} results */
export function report(mutants, results) {
	const kinds = KINDS.map((kind) => [kind, mutants.filter((mutant) => mutant.kind === kind)]);
	const rows = [...kinds, ["all", mutants]].map(([name, some]) => row(name, some, results));
	const table = [["", "listed", ...COLUMNS, "time"], ...rows].map((cells) =>
		cells.map((cell, i) => (i === 0 ? String(cell).padEnd(6) : String(cell).padStart(9))).join(""),
	);
	const known = mutants.filter(({ id, survives }) => survives && outcomeOf(results.get(id)) === "survived");
	const lines = known.map(({ id, survives }) => `${id} survives, as is known: ${survives}`);
	const share = (100 * shareCaught(mutants, results)).toFixed(1);
	return [...table, "", ...lines, ...complaints(mutants, results), `${share} % of those that have run are caught`].join(
		"\n",
	);
}
