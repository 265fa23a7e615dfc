/** Natural bunches of the real core in every form: presets, ages, random parameters. */

import { readFileSync } from "node:fs";
import fc from "fast-check";
import { Box3, Vector3 } from "three";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { fetchLeaf } from "../../../../../web/src/models/bunch/leaf";
import type { NumberKey } from "../../../../../web/src/models/bunch/parameters.generated";
import type { BunchRequestOptions } from "../../../../../web/src/models/bunch/request";
import { berriesCsv } from "../../../../../web/src/models/bunch/tables";
import { inRun } from "../../../../long_run.mjs";
import { exportJson, presetsInRun, type Specimen, specimenFromFile, specimenFromPreset } from "../../../bunch";
import { growBunch } from "../../../core/wasm";
import { complaints, documentOf, load, meshesOf } from "../../../formats/reading";
import { loadObj } from "../../../formats/reading_obj";
import { fingerprintOfDocument } from "../fingerprint";
import { bunchGlb, bunchObj } from "./files";

let core: Core;

beforeAll(async () => {
	core = await loadCoreFromBytes(readFileSync("build/core/bunch.wasm"));
	await fetchLeaf();
});

const grow = (specimen: Specimen, options?: BunchRequestOptions) => growBunch(core, specimen, options);
/** Without cane and leaves by default: leaves have textures, which three.js loads in browsers only. */
const natural = (name: string, parameters: Partial<Record<NumberKey, number>> = {}): Specimen => {
	const specimen = specimenFromPreset(name);
	return { ...specimen, parameters: { ...specimen.parameters, leaves: 0, cane: 0, ...parameters, procedure: 1 } };
};
/** Fewer triangles for tests of the file format. */
const COARSE: BunchRequestOptions = { stemSides: 5, berrySegments: 8 };

describe.each(presetsInRun())("%s", (name) => {
	const specimen = natural(name);
	let grown: BunchPlant;
	beforeAll(() => {
		grown = grow(specimen, COARSE);
	});

	it("comes back through three.js from a GLB in both forms, with unique names and every berry in place", async () => {
		expect(grown.surfaces?.positions.length).toBe(grown.berries.count * (grown.surfaces?.uvs.length ?? 0) * 1.5);
		for (const compact of [false, true]) {
			const glb = await bunchGlb(grown, specimen, { compact });
			const names = documentOf(glb).nodes.map((node) => node.name);
			expect(new Set(names).size).toBe(names.length);
			const { scene } = await load(glb);
			scene.updateMatrixWorld(true);
			const berries = meshesOf(scene).filter(({ userData }) => userData.name.startsWith("Berry "));
			expect(berries).toHaveLength(grown.berries.count);
			const apart = berries.map(({ matrixWorld }, i) =>
				new Vector3()
					.setFromMatrixPosition(matrixWorld)
					.distanceTo(new Vector3().fromArray(grown.berries.spheres, 4 * i)),
			);
			expect(Math.max(0, ...apart)).toBeLessThan(1e-6);
			const drawn = new Box3().setFromObject(scene, true);
			const grew = new Box3().setFromArray([...(grown.stem?.positions ?? []), ...(grown.surfaces?.positions ?? [])]);
			expect(drawn.min.distanceTo(grew.min) + drawn.max.distanceTo(grew.max)).toBeLessThan(1e-5);
		}
	});

	it("gives its fingerprint again from the JSON, and its specimen from every file that holds it", async () => {
		const json = JSON.stringify(exportJson(grown, specimen));
		expect(fingerprintOfDocument(JSON.parse(json))).toBe(grown.fingerprint);
		const files = [await bunchGlb(grown, specimen), new TextEncoder().encode(json)];
		for (const file of files) expect(await specimenFromFile(name, new Blob([file]))).toEqual({ specimen, notes: [] });
		expect(berriesCsv(grown, specimen).split("\r\n")).toHaveLength(grown.berries.count + 2);
	});
});

describe("a natural bunch", () => {
	it.each(inRun(["rubus"], ["redcurrant", "rubus", "pizzutello"]))(
		"of %s comes back from OBJ with the GLB's triangles and bounds",
		async (name) => {
			const specimen = natural(name);
			const grown = grow(specimen, COARSE);
			const group = loadObj(bunchObj(grown, specimen, name));
			const { scene } = await load(await bunchGlb(grown, specimen));
			const corners = (root: typeof group) =>
				meshesOf(root).reduce((sum, { geometry }) => sum + (geometry.index ?? geometry.attributes.position).count, 0);
			expect(corners(group)).toBe(corners(scene));
			const [box, expected] = [new Box3().setFromObject(group, true), new Box3().setFromObject(scene, true)];
			expect(box.min.distanceTo(expected.min) + box.max.distanceTo(expected.max)).toBeLessThan(4e-6);
		},
	);

	it.each(inRun([5, 110], [0, 5, 15, 50, 80, 110, 125]))(
		"of age %d with leaves is a valid GLB with cane, leaves and flowers",
		async (age) => {
			const specimen = natural("long-conical", { age, leaves: 3, cane: 1 });
			const grown = grow(specimen, COARSE);
			for (const compact of [false, true]) {
				const glb = await bunchGlb(grown, specimen, { compact });
				expect(await complaints(glb)).toEqual([]);
				const names = documentOf(glb).nodes.map((node) => node.name);
				expect(names.filter((each) => each.startsWith("Leaf "))).toHaveLength(3);
				expect(names).toContain("Cane");
				// The first flowers open; by fruit set all stamens have fallen.
				expect(names.some((each) => each.startsWith("Flower "))).toBe(age <= 5);
			}
		},
	);

	/** Large and dense settings may exceed the core's limit, which it reports. */
	const grownOrTooLarge = (specimen: Specimen) => {
		try {
			return grow(specimen, COARSE);
		} catch (error) {
			expect(String(error)).toMatch(/the limit of 20000 (flowers|berries)/);
			return undefined;
		}
	};

	it("is valid whatever the panel is set to", async () => {
		const range = (min: number, max: number) => fc.integer({ min: 2 * min, max: 2 * max }).map((steps) => steps / 2);
		const parameters = fc.record({
			l: fc.integer({ min: 40, max: 400 }),
			p3w: fc.integer({ min: 0, max: 200 }),
			p5w: fc.integer({ min: 0, max: 200 }),
			size: range(5, 25),
			density: range(1, 9),
			age: range(0, 125),
			elongation: range(1, 3),
			fruit: fc.integer({ min: 0, max: 5 }),
			leaves: fc.integer({ min: 0, max: 5 }),
			spread: fc.integer({ min: 0, max: 40 }),
		});
		await fc.assert(
			fc.asyncProperty(parameters, fc.nat(), fc.boolean(), async (values, seed, compact) => {
				const specimen = { ...natural("short-conical", values), seed };
				const grown = grownOrTooLarge(specimen);
				if (!grown) return;
				expect(await complaints(await bunchGlb(grown, specimen, { compact }))).toEqual([]);
				expect(fingerprintOfDocument(exportJson(grown, specimen))).toBe(grown.fingerprint);
			}),
			// The largest take seconds each: shrinking a counterexample would exceed the test's time.
			{ numRuns: inRun(2, 15), endOnFailure: true },
		);
	});

	it("keeps berries removed by hand", async () => {
		const whole = natural("short-conical");
		const [first, second] = grow(whole, { meshes: false }).berries.ids;
		const specimen = { ...whole, thinned: [second, first] };
		const grown = grow(specimen, COARSE);
		expect([...grown.berries.ids]).not.toContain(first);
		const byHand = exportJson(grown, specimen).thinned.filter(({ why }) => why === "by hand");
		expect(byHand.map(({ id }) => id).sort()).toEqual([first, second].sort());
		const { specimen: read } = await specimenFromFile("bunch.glb", new Blob([await bunchGlb(grown, specimen)]));
		expect(read).toEqual(specimen);
	});
});
