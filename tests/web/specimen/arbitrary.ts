import fc from "fast-check";
import { PRESETS } from "../../../web/src/models/bunch/presets/presets";
import { type ChoiceEntry, type NumberEntry, valueIn } from "../../../web/src/specimen/table";
import { BERRY_IDS, ENTRIES, MAX_THINNED, type Specimen, specimenFromPreset } from "../bunch";

/** Any value that the table allows and a link can hold. */
function allowed(entry: NumberEntry | ChoiceEntry): fc.Arbitrary<number> {
	const scale = entry.kind === "number" ? 100 : 1;
	const from = entry.gapBelow ?? entry.min;
	const inRange = fc
		.integer({ min: Math.round(from * scale), max: Math.round(entry.max * scale) })
		.map((steps) => steps / scale);
	return entry.gapBelow === undefined ? inRange : fc.oneof(fc.constant(entry.min), inRange);
}

const colour = fc.integer({ min: 0, max: 0xffffff }).map((rgb) => rgb.toString(16).padStart(6, "0"));

const changes = fc.record(
	Object.fromEntries(ENTRIES.map((entry) => [entry.key, entry.kind === "colour" ? colour : allowed(entry)])),
	{ requiredKeys: [] },
) as fc.Arbitrary<Record<string, number | string>>;

const inputs = fc.oneof(
	fc.constant(undefined),
	fc.integer({ min: 1, max: 100 }).map((m) => ({ m })),
	fc.array(fc.integer({ min: 0, max: 100 }), { minLength: 1, maxLength: 99 }).map((n) => ({ m: n.length + 1, n })),
);

const thinned = fc.uniqueArray(fc.integer({ min: 0, max: BERRY_IDS - 1 }), { maxLength: MAX_THINNED });

const grammar = fc.option(fc.string({ unit: "grapheme", minLength: 1, maxLength: 400 }), { nil: undefined });

/** Any valid specimen: complete, in range, on the steps that a link holds. */
export const anySpecimen: fc.Arbitrary<Specimen> = fc
	.record({
		preset: fc.constantFrom(...PRESETS.map((preset) => preset.name)),
		seed: fc.oneof(fc.constant(1), fc.nat(), fc.constant(0xffffffff)),
		version: fc.constantFrom(1, 2),
		changes,
		thinned,
		inputs,
		grammar,
	})
	.map(({ preset, seed, version, changes, thinned, inputs, grammar }) => {
		const specimen: Specimen = { ...specimenFromPreset(preset, version), seed, thinned };
		for (const entry of ENTRIES) {
			if (!(entry.key in changes)) continue;
			Object.assign(entry.look ? specimen.look : specimen.parameters, { [entry.key]: changes[entry.key] });
		}
		const { rmin, rmax } = specimen.parameters;
		specimen.parameters.rmin = Math.min(rmin, rmax);
		specimen.parameters.rmax = Math.max(rmin, rmax);
		if (inputs) specimen.inputs = inputs;
		if (grammar !== undefined) specimen.grammar = grammar;
		return specimen;
	});

/** Why a specimen is not valid; empty where it is. */
export function faults(specimen: Specimen): string[] {
	const found: string[] = [];
	for (const entry of ENTRIES) {
		const value = valueIn(specimen, entry);
		if (entry.kind === "colour") {
			if (!/^[0-9a-f]{6}$/.test(String(value))) found.push(`${entry.key} ${value}`);
			continue;
		}
		const { min, max, gapBelow } = entry;
		const number = value as number;
		const fits = number >= min && number <= max && !(gapBelow !== undefined && number > 0 && number < gapBelow);
		const whole = entry.kind === "number" || Number.isInteger(number);
		if (typeof number !== "number" || !fits || !whole || Object.is(number, -0)) found.push(`${entry.key} ${number}`);
	}
	const { v, seed, inputs, parameters, preset, thinned } = specimen;
	if (v !== 2) found.push(`v ${v}`);
	if (thinned.length > MAX_THINNED || new Set(thinned).size < thinned.length) found.push("thinned's length");
	if (thinned.some((id) => !Number.isInteger(id) || id < 0 || id >= BERRY_IDS)) found.push("thinned");
	if (!Number.isInteger(seed) || seed < 0 || seed > 0xffffffff) found.push(`seed ${seed}`);
	if (parameters.rmin > parameters.rmax) found.push("rmin above rmax");
	if (!PRESETS.some((each) => each.name === preset)) found.push(`preset ${preset}`);
	if (inputs?.m !== undefined && !(Number.isInteger(inputs.m) && inputs.m >= 1 && inputs.m <= 100)) found.push("m");
	if (inputs?.n && inputs.n.length !== (inputs.m ?? 0) - 1) found.push("n's length");
	if (inputs?.n?.some((n) => !Number.isInteger(n) || n < 0 || n > 100)) found.push("n");
	return found;
}
