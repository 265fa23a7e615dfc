/** Drying bunches: their losses from ripe to raisin. */
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import type { BunchPlant } from "../../../../web/src/models/bunch/bunch_plant";
import { presetsInRun, specimenFromPreset } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

const AGES = [100, 102.5, 105, 110, 115, 120, 125];

let core: Core;
beforeAll(async () => {
	core = await freshCore();
});

function aged(preset: string, seed: number, age: number): BunchPlant {
	const specimen = specimenFromPreset(preset);
	return growBunch(core, { ...specimen, seed, parameters: { ...specimen.parameters, age } }, { meshes: false });
}

const idsOf = ({ berries }: BunchPlant) => new Set(berries.ids);

it.each(presetsInRun())("%s gains no berry as it dries, and no berry that was not there", (preset) => {
	for (const seed of [1, 2]) {
		const bunches = AGES.map((age) => aged(preset, seed, age));
		for (const [k, bunch] of bunches.entries()) {
			if (k === 0) continue;
			const before = idsOf(bunches[k - 1]);
			expect([...bunch.berries.ids].filter((id) => !before.has(id))).toEqual([]);
		}
	}
});

it("leaves half of a berry's volume, or less", () => {
	for (const preset of ["merlot", "thompson-seedless"]) {
		const volume = (age: number) => {
			const { spheres, count } = aged(preset, 1, age).berries;
			return Array.from({ length: count }, (_, i) => spheres[4 * i + 3] ** 3).reduce((sum, v) => sum + v, 0) / count;
		};
		expect(volume(125) / volume(100)).toBeLessThan(0.55);
	}
});
