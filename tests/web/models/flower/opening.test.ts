/** From bud to open to wilted: one map, and nothing jumps. */
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { fetchTexts } from "../../../../web/src/models/flower/texts";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";

const STEPS = 8;

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
});

const opening = model.presets.list.filter(({ kind }) => kind !== "figures").map(({ name }) => name);

function grown(name: string, age: number): FlowerPlant {
	const specimen = fromPreset(model, name);
	const parameters = { ...specimen.parameters, age, smooth: 0 };
	return readFlowerPlant(
		core.grow(model.encode({ ...specimen, parameters }, { sky: false, map: false, measures: false })),
	);
}

/** The farthest that a corner moves, metres. */
function moved(from: FlowerPlant, to: FlowerPlant): number {
	let far = 0;
	for (const [i, { positions }] of from.meshes.entries()) {
		const there = to.meshes[i].positions;
		for (let at = 0; at < positions.length; at += 3) {
			const x = there[at] - positions[at];
			const y = there[at + 1] - positions[at + 1];
			const z = there[at + 2] - positions[at + 2];
			far = Math.max(far, x * x + y * y + z * z);
		}
	}
	return Math.sqrt(far);
}

it.each(opening)("%s opens and wilts on the same map, without a jump", (name) => {
	const ages = Array.from({ length: STEPS + 1 }, (_, i) => (2 * i) / STEPS);
	const plants = ages.map((age) => grown(name, age));
	for (const { volumes, meshes } of plants) {
		expect(volumes.label).toEqual(plants[0].volumes.label);
		expect(volumes.order).toEqual(plants[0].volumes.order);
		expect(volumes.parent).toEqual(plants[0].volumes.parent);
		expect(meshes.map(({ positions }) => positions.length)).toEqual(
			plants[0].meshes.map(({ positions }) => positions.length),
		);
	}
	const steps = ages.slice(1).map((_, i) => moved(plants[i], plants[i + 1]));
	const most = Math.max(...steps);
	expect(Math.max(...steps.slice(0, STEPS / 2)), "opens").toBeGreaterThan(0.002);
	expect(Math.max(...steps.slice(STEPS / 2)), "wilts").toBeGreaterThan(0.0002);
	// Where most happens it is halved until a jump would be all that is left.
	let low = ages[steps.indexOf(most)];
	let width = 2 / STEPS;
	let [first, last] = [grown(name, low), grown(name, low + width)];
	for (let halving = 0; halving < 4; halving++) {
		width /= 2;
		const middle = grown(name, low + width);
		if (moved(first, middle) >= moved(middle, last)) {
			last = middle;
		} else {
			first = middle;
			low += width;
		}
	}
	expect(moved(first, last)).toBeLessThan(most / 4);
});
