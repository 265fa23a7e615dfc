/** Data of the natural procedure across the core's border; the core's own tests check the bunches themselves. */

import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { FRUITS, PROCEDURES, TRAITS, type Trait } from "../../../../web/src/models/bunch/bunch_plant";
import { PRESETS } from "../../../../web/src/models/bunch/presets/presets";
import type { ChoiceEntry } from "../../../../web/src/specimen/table";
import { entryOf, type Specimen, specimenFromPreset, thin, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

const grow = (specimen: Specimen) => growBunch(core, specimen);
const small = () => specimenFromPreset("short-conical");

it("the names of choices are those of the table", () => {
	expect((entryOf("procedure") as ChoiceEntry).options).toEqual(PROCEDURES);
	expect((entryOf("fruit") as ChoiceEntry).options).toEqual(FRUITS);
});

describe("a natural bunch", () => {
	it("gives the fruit of its berries, and their form", () => {
		for (const { name } of PRESETS.filter(({ kind }) => kind === "fruit")) {
			const { parameters } = specimenFromPreset(name);
			const { form } = growBunch(core, specimenFromPreset(name), { meshes: false });
			expect(form.fruit).toBe(FRUITS[parameters.fruit]);
		}
		const { form } = grow(withParameters(small(), { taper: -0.5, blunt: 0.25, curve: 0.75 }));
		expect(form).toEqual({ fruit: "grape", taper: -0.5, blunt: 0.25, curve: 0.75 });
	});

	it("gives every berry its traits, in range", () => {
		for (const age of [0, 5, 30, 70, 100, 125]) {
			const { berries } = grow(withParameters(small(), { age }));
			const of = (trait: Trait) => berries.traits.filter((_, i) => i % TRAITS.length === TRAITS.indexOf(trait));
			for (const trait of ["exposure", "turned", "opened", "set", "shrivel"] as const) {
				for (const value of of(trait)) expect(value).toBeGreaterThanOrEqual(0);
				for (const value of of(trait)) expect(value).toBeLessThanOrEqual(1);
			}
			for (const value of of("width")) expect(value).toBeGreaterThan(0);
			for (const value of of("length")) expect(value).toBeGreaterThan(0);
		}
	});

	it("gives every berry a surface of the shared pattern", () => {
		const { surfaces, berries } = grow(small());
		if (!surfaces) throw new Error("no surfaces");
		const vertices = surfaces.uvs.length / 2;
		expect(surfaces.positions.length).toBe(3 * vertices * berries.count);
		expect(surfaces.normals.length).toBe(3 * vertices * berries.count);
		expect(surfaces.pressed.length).toBe(vertices * berries.count);
		expect(Math.max(...surfaces.indices)).toBe(vertices - 1);
		expect(Math.max(...surfaces.pressed)).toBeGreaterThan(0);
	});

	it("omits the berry that was removed by hand, lists it, and keeps the others' ids", () => {
		const whole = grow(small());
		const [id] = whole.berries.ids;
		const { berries, thinned } = grow(thin(small(), id));
		expect(berries.ids).not.toContain(id);
		expect(berries.count).toBe(whole.berries.count - 1);
		expect([...berries.ids]).toEqual([...whole.berries.ids].filter((each) => each !== id));
		expect(thinned.filter(({ why }) => why === "by hand").map((berry) => berry.id)).toEqual([id]);
		for (const { place } of thinned) expect(place.every(Number.isFinite)).toBe(true);
	});

	it("is not troubled by an id that it has not", () => {
		const odd = thin(small(), 2 ** 30 - 1);
		expect(grow(odd).fingerprint).toBe(grow(small()).fingerprint);
	});

	it("computes measures only on request", () => {
		expect(growBunch(core, small(), { measures: false }).measures).toBeUndefined();
		expect(growBunch(core, small(), { meshes: false }).fingerprint).toBe(grow(small()).fingerprint);
	});
});
