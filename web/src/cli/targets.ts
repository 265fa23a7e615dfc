/** `--target KEY=VALUE` and `KEY=FROM..TO`: target measures in place of parameters. */
import type { Goal } from "../batch/goals";
import type { Model } from "../models/model";
import { keyAndValue, splitAtFirst } from "../specimen/halves";
import { readNumber } from "../specimen/read_values";
import type { Specimen } from "../specimen/specimen";
import { UsageError } from "./usage";

/** @throws UsageError */
export function readTargets(model: Model, specimen: Specimen, texts: readonly string[]): Goal[] {
	const known = model.targets?.measures(specimen) ?? [];
	const goals = texts.map((text) => readOne(text, known, model.noun));
	const twice = goals.find(({ measure }, at) => goals.findIndex((each) => each.measure === measure) < at);
	if (twice) throw new UsageError(`--target ${twice.measure}: given twice`);
	return goals;
}

function readOne(text: string, known: readonly string[], noun: string): Goal {
	const [key, written] = keyAndValue(text) ?? [];
	if (key === undefined || written === undefined) {
		throw new UsageError(`--target ${text}: write MEASURE=VALUE, as in --target ${known[0] ?? "height"}=160`);
	}
	if (known.length === 0)
		throw new UsageError(`--target ${key}: the model ${noun} has no measures that can be targets`);
	if (!known.includes(key)) {
		throw new UsageError(`--target ${key}: not a measure of this ${noun} that can be a target; see --help`);
	}
	const [from, to] = (splitAtFirst(written, "..") ?? [written, written]).map((value) => {
		const number = readNumber(value);
		if (number === undefined || number < 0)
			throw new UsageError(`--target ${key}: “${value}” is not a number of 0 or more`);
		return number;
	});
	if (from > to) throw new UsageError(`--target ${key}: ${written} runs backwards; write ${to}..${from}`);
	return { measure: key, from, to };
}
