/** `--target KEY=VALUE`: measures asked for in place of parameters. */
import type { Model } from "../models/model";
import { keyAndValue } from "../specimen/halves";
import { readNumber } from "../specimen/read_values";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { UsageError } from "./usage";

/** @throws UsageError */
export function readTargets(model: Model, specimen: Specimen, texts: readonly string[]): Aim[] {
	const known = model.targets?.measures(specimen) ?? [];
	const aims = texts.map((text) => readOne(text, known, model.noun));
	const twice = aims.find(({ measure }, at) => aims.findIndex((each) => each.measure === measure) < at);
	if (twice) throw new UsageError(`--target ${twice.measure}: given twice`);
	return aims;
}

function readOne(text: string, known: readonly string[], noun: string): Aim {
	const [key, written] = keyAndValue(text) ?? [];
	if (key === undefined || written === undefined) {
		throw new UsageError(`--target ${text}: write MEASURE=VALUE, as in --target ${known[0] ?? "height"}=160`);
	}
	if (known.length === 0) throw new UsageError(`--target ${key}: of a ${noun} no measure can be asked for`);
	if (!known.includes(key)) {
		throw new UsageError(`--target ${key}: no measure of this ${noun} that can be asked for; see --help`);
	}
	const value = readNumber(written);
	if (value === undefined || value < 0) throw new UsageError(`--target ${key}: “${written}” is no number from 0 on`);
	return { measure: key, value };
}
