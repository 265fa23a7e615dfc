import { expect, it } from "vitest";
import { type BunchPlant, THINNED_WHY, TRAITS } from "../../../../web/src/models/bunch/bunch_plant";
import { fetchLeaf } from "../../../../web/src/models/bunch/leaf";
import { readBunchPlant } from "../../../../web/src/models/bunch/read_bunch_plant";
import { encodeRequest } from "../../../../web/src/models/bunch/request";
import { specimenFromPreset, withParameters } from "../../bunch";
import { freshCore } from "../../core/wasm";

/** Returns whether two arrays have the same type and values; faster than a structural diff. */
const same = (a: ArrayBufferView, b: ArrayBufferView) =>
	a.constructor === b.constructor &&
	Buffer.from(a.buffer, a.byteOffset, a.byteLength).equals(Buffer.from(b.buffer, b.byteOffset, b.byteLength));

/** A bunch with every column, and the columns it was read from. */
async function both() {
	const specimen = withParameters(specimenFromPreset("short-conical"), { age: 60, leaves: 1, wing: 0.4 });
	await fetchLeaf();
	const { columns, milliseconds } = (await freshCore()).grow(encodeRequest(specimen));
	// Reads from a copy, so that a modified input is detected.
	const came = structuredClone(Object.fromEntries(columns.names.map((name) => [name, columns.any(name)])));
	return { grown: readBunchPlant({ columns, milliseconds }) as Required<BunchPlant>, came };
}

it("every column is read where it belongs", async () => {
	const { grown, came } = await both();
	const { berries, internodes, surfaces, stem, thinned, plan, second } = grown;
	expect(same(internodes.axis, came["segments.axis"])).toBe(true);
	expect(same(internodes.state, came["segments.state"])).toBe(true);
	expect(same(internodes.ends, came["segments.ends"])).toBe(true);
	expect(same(internodes.radii, came["segments.radii"])).toBe(true);
	expect(same(berries.spheres, came["berries.spheres"])).toBe(true);
	expect(same(berries.directions, came["berries.directions"])).toBe(true);
	expect(same(berries.ids, came["berries.id"])).toBe(true);
	TRAITS.forEach((trait, k) => {
		expect(
			same(
				berries.traits.filter((_, i) => i % TRAITS.length === k),
				came[`berries.${trait}`],
			),
		).toBe(true);
	});
	expect(same(surfaces.pressed, came["berries.pressed"])).toBe(true);
	expect(new Set(surfaces.pressed).size).toBeGreaterThan(2);
	expect(same(surfaces.normals, came["berries.normals"])).toBe(true);
	expect(same(stem.internode, came["mesh.stems.segment"])).toBe(true);
	expect(stem.parts.map(({ axis }) => axis)).toEqual([...came["mesh.stems.axis"]]);
	expect(thinned.flatMap(({ place }) => place)).toEqual([...came["thinned.places"]]);
	expect(thinned.map(({ why }) => why)).toEqual([...came["thinned.why"]].map((why) => THINNED_WHY[why]));
	for (const [name, read] of [
		["plan", plan],
		["second", second],
	] as const) {
		expect([read.m, ...read.axes]).toEqual([...came[`${name}.axes`]]);
		expect(read.sides.flatMap(({ w, r }) => [w, r])).toEqual([...came[`${name}.sides`]]);
		expect(read.sides.flatMap(({ n, rd }) => [n, rd])).toEqual([...came[`${name}.counts`]]);
	}
	const leaf = grown.foliage.parts.find(({ kind }) => kind === "leaf");
	expect(leaf?.indexCount).toBeGreaterThan(0);
});
