import { describe, expect, it } from "vitest";
import { CAST_RECORD, CASTERS, Casters, type Lamp } from "../../../../../web/src/models/bunch/figure/casters";
import { packReceivers, RECORD, receiverTexels } from "../../../../../web/src/models/bunch/figure/receivers";
import { berryTint } from "../../../../../web/src/models/bunch/parts/berry_tint";
import { skinOf } from "../../../../../web/src/models/bunch/parts/skin";
import { lampHidden } from "../../../../../web/src/scene/occlusion";
import { LOOK, RIPE, sampleBunch } from "../sample_bunch";

const skin = skinOf(LOOK);
const key: Lamp = { direction: [-0.566, 0.602, 0.564], spread: 0.17 };
const rim: Lamp = { direction: [0.8, 0, -0.6], spread: 0.2 };

const bunch = sampleBunch(90);
const receivers = packReceivers(bunch, (b) => berryTint(skin, b, RIPE), new Float32Array(4 * receiverTexels(bunch)));
const records = new Float32Array(receivers.count * CAST_RECORD * 4);
new Casters().cast(receivers, key, rim, records);

/** Spheres on receiver `i`'s way to the lamp, found by looking at all of them. */
function inTheWay(i: number, lamp: Lamp): { j: number; along: number; lateral: number; radius: number }[] {
	const { spheres } = receivers.index;
	const at = 4 * RECORD * i;
	const found = [];
	for (let j = 0; j < bunch.berries.count; j++) {
		if (j === i) continue;
		const d = [0, 1, 2].map((k) => spheres[4 * j + k] - receivers.records[at + k]);
		const along = d[0] * lamp.direction[0] + d[1] * lamp.direction[1] + d[2] * lamp.direction[2];
		const lateral = Math.sqrt(Math.max(0, d[0] ** 2 + d[1] ** 2 + d[2] ** 2 - along ** 2));
		found.push({ j, along, lateral, radius: spheres[4 * j + 3] });
	}
	return found;
}

describe("Casters", () => {
	it("lists the nearest spheres between each berry and the key light", () => {
		for (let i = 0; i < bunch.berries.count; i++) {
			const extent = receivers.records[4 * RECORD * i + 3];
			const expected = inTheWay(i, key)
				.filter(({ along, lateral, radius }) => along > -radius && lateral < radius + extent)
				.sort((a, b) => a.along - b.along)
				.slice(0, 3);
			const listed: number[] = [];
			for (let k = 1; k <= CASTERS; k++) {
				const at = 4 * (CAST_RECORD * i + k);
				if (records[at + 3] === 0) break;
				const centre = [0, 1, 2].map((c) => records[at + c] + receivers.records[4 * RECORD * i + c]);
				listed.push(nearestTo(centre));
			}
			for (const { j } of expected.slice(0, Math.max(0, CASTERS - 6))) expect(listed).toContain(j);
			expect(listed).not.toContain(i);
		}
	});

	it.each([
		["key", key, 0],
		["rim", rim, 1],
	] as const)("shares out the %s light as looking at every sphere would", (_, lamp, channel) => {
		for (let i = 0; i < receivers.count; i++) {
			let share = 1;
			for (const { radius, lateral, along, j } of inTheWay(i, lamp)) {
				if (j !== i) share *= 1 - lampHidden(radius, lateral, along, lamp.spread);
			}
			expect(Math.abs(records[4 * CAST_RECORD * i + channel] - share)).toBeLessThan(0.03);
		}
	});

	it("leaves the berries nearest the light in it", () => {
		const toward = (i: number) =>
			[0, 1, 2].reduce((sum, k) => sum + receivers.records[4 * RECORD * i + k] * key.direction[k], 0);
		const order = Array.from({ length: bunch.berries.count }, (_, i) => i).sort((a, b) => toward(b) - toward(a));
		expect(records[4 * CAST_RECORD * order[0]]).toBeGreaterThan(0.95);
	});
});

function nearestTo(centre: number[]): number {
	const { spheres } = receivers.index;
	let best = -1;
	let least = Infinity;
	for (let j = 0; j < bunch.berries.count; j++) {
		const away = Math.hypot(...centre.map((c, k) => c - spheres[4 * j + k]));
		if (away < least) [best, least] = [j, away];
	}
	return best;
}
