/** `--target KEY=VALUE` and `KEY=FROM..TO`: target measures in place of parameters. */
import type { Goal } from "../batch/goals";
import type { Model } from "../models/model";
import { keyAndValue, splitAtFirst } from "../specimen/halves";
import { readNumber } from "../specimen/read_values";
import type { Specimen } from "../specimen/specimen";
import { text } from "./messages.generated";
import { optionError } from "./usage";

/**
 * Reads the targets of a call: measures and the values that the plant should have.
 * @throws UsageError
 */
export function readTargets(model: Model, specimen: Specimen, texts: readonly string[]): Goal[] {
	const known = model.targets?.measures(specimen) ?? [];
	const goals = texts.map((written) => readOne(written, known, model.name));
	const twice = goals.find(({ measure }, at) => goals.findIndex((each) => each.measure === measure) < at);
	if (twice) throw optionError(`--target ${twice.measure}`, text.message("target_twice"));
	return goals;
}

/**
 * Reads one target; a single value is a range from and to it.
 * @param known measures that can be targets
 */
function readOne(target: string, known: readonly string[], model: string): Goal {
	const [key, written] = keyAndValue(target) ?? [];
	if (key === undefined || written === undefined) {
		throw optionError(`--target ${target}`, text.message("write_target", { measure: known[0] ?? "height" }));
	}
	if (known.length === 0) throw optionError(`--target ${key}`, text.message("no_targets", { model }));
	if (!known.includes(key)) {
		throw optionError(`--target ${key}`, text.message("target_unknown"));
	}
	const [from, to] = (splitAtFirst(written, "..") ?? [written, written]).map((value) => {
		const number = readNumber(value);
		if (number === undefined || number < 0)
			throw optionError(`--target ${key}`, text.message("target_not_a_number", { value }));
		return number;
	});
	if (from > to) {
		const named = { written, to: String(to), from: String(from) };
		throw optionError(`--target ${key}`, text.message("range_backwards", named));
	}
	return { measure: key, from, to };
}
