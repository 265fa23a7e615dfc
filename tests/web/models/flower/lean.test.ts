/** Stems bend to the right, seen from the front, if `bend` is above 0: gestures rely on this (gestures/lean.ts). */
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { fetchedText, fetchTexts } from "../../../../web/src/models/flower/texts";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { namesInRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";

const GATE = ["tulip", "daisy", "poppy", "bluebell", "raceme", "designed-lily"];
const NAMES = model.presets.list.map(({ name }) => name);

let core: Core;
let bending: string[];
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("flower.wasm");
	bending = NAMES.filter((name) => /^#define bend=.*-5 … 5/m.test(fetchedText({ preset: name }) ?? ""));
});

/** Returns the centre of everything but stems and leaves, metres. */
function headOf({ meshes }: FlowerPlant): [x: number, y: number, z: number] {
	const sum: [number, number, number] = [0, 0, 0];
	let count = 0;
	for (const { material, positions } of meshes) {
		if (material === "stem" || material === "leaf") continue;
		for (let i = 0; i < positions.length; i++) sum[i % 3] += positions[i];
		count += positions.length / 3;
	}
	return [sum[0] / count, sum[1] / count, sum[2] / count];
}

function head(name: string, constants: Readonly<Record<string, number>>) {
	const specimen = { ...fromPreset(model, name), constants };
	return headOf(readFlowerPlant(core.grow(model.encode(specimen, { map: false }))));
}

describe("a stem that bends", () => {
	it("is of every species and inflorescence whose stem is a number of the text", () => {
		expect(bending.length).toBeGreaterThan(20);
	});

	it("takes the head to the right where `bend` is above 0, and to the left where it is below", () => {
		for (const name of namesInRun(bending, GATE)) {
			const straight = head(name, { bend: 0 });
			for (const bend of [3, -3]) {
				const bent = head(name, { bend });
				const [x, z] = [bent[0] - straight[0], bent[2] - straight[2]];
				expect(Math.sign(x), `${name} by ${bend}`).toBe(Math.sign(bend));
				// As seen in the first view, from 24° to the right, too, and hardly to the front or the back.
				expect(Math.abs(z), name).toBeLessThan(0.2 * Math.abs(x));
				expect(Math.abs(x), name).toBeGreaterThan(0.1 * straight[1]);
			}
		}
	});
});
