/** From bud to open to wilted: one map, and nothing jumps. */
import { beforeAll, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { fetchedText, fetchTexts } from "../../../../web/src/models/flower/texts";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { namesInRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";

const STEPS = 8;
/** Least visible movement, metres. */
const LEAST = 0.001;

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
});

/**
 * Presets of the short test run, one of each way to open: petals on a ring, florets of a head, flowers of an
 * inflorescence, and a clock that scatters.
 */
const GATE_PRESETS = ["tulip", "daisy", "umbel", "dandelion-clock"];
const opening = namesInRun(
	model.presets.list.filter(({ kind }) => kind !== "figures").map(({ name }) => name),
	GATE_PRESETS,
);

function grown(name: string, age: number): FlowerPlant {
	const specimen = fromPreset(model, name);
	const parameters = { ...specimen.parameters, age, smooth: 0 };
	// A corner of a meadow is enough: each of its plants opens by itself.
	const grammar = fetchedText(specimen)?.replace(/(#define across=)\d+/, (_, define) => `${define}8`);
	return readFlowerPlant(
		core.grow(model.encode({ ...specimen, parameters, grammar }, { sky: false, map: false, measures: false })),
	);
}

/** Returns how far each corner moves, metres. */
function moves(from: FlowerPlant, to: FlowerPlant): Float32Array {
	const all = new Float32Array(from.meshes.reduce((sum, { positions }) => sum + positions.length / 3, 0));
	let corner = 0;
	for (const [i, { positions }] of from.meshes.entries()) {
		const there = to.meshes[i].positions;
		for (let at = 0; at < positions.length; at += 3)
			all[corner++] = Math.hypot(
				there[at] - positions[at],
				there[at + 1] - positions[at + 1],
				there[at + 2] - positions[at + 2],
			);
	}
	return all;
}

/**
 * Returns whether a corner jumps between two ages. A smooth movement covers about half its way in each half of the
 * time; a half with nearly all of the way is split again, and a corner for which this repeats jumps.
 */
function jumps(name: string, low: number, high: number, from: FlowerPlant, to: FlowerPlant, halvings = 7): boolean {
	const middle = (low + high) / 2;
	const between = grown(name, middle);
	const [whole, first, last] = [moves(from, to), moves(from, between), moves(between, to)];
	let worst = -1;
	for (const [corner, way] of whole.entries()) {
		if (way < LEAST || Math.max(first[corner], last[corner]) < 0.9 * way) continue;
		if (worst < 0 || way > whole[worst]) worst = corner;
	}
	if (worst < 0) return false;
	if (halvings === 0) return true;
	return first[worst] > last[worst]
		? jumps(name, low, middle, from, between, halvings - 1)
		: jumps(name, middle, high, between, to, halvings - 1);
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
	const farthest = (from: number, to: number) =>
		moves(plants[from], plants[to]).reduce((most, way) => Math.max(most, way));
	expect(farthest(0, STEPS / 2), "opens").toBeGreaterThan(LEAST);
	expect(farthest(STEPS / 2, STEPS), "wilts").toBeGreaterThan(LEAST / 4);
	const jumping = ages.slice(1).filter((age, i) => jumps(name, ages[i], age, plants[i], plants[i + 1]));
	expect(jumping).toEqual([]);
});
