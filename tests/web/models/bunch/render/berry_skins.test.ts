import fc from "fast-check";
import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { packVertices, skiesOf, surfacesOf } from "../../../../../web/src/models/bunch/render/berry_skins";
import { evenly } from "../../../evenly";
import { pressedBunch } from "../pressed_bunch";
import { sampleBunch } from "../sample_bunch";

describe("surfacesOf", () => {
	it("takes a natural bunch's own surfaces as they are", () => {
		const bunch = pressedBunch({ count: 6 });
		expect(surfacesOf(bunch)).toBe(bunch.surfaces);
	});

	it("puts the shared berry at every sphere of the paper's, tip along its direction", () => {
		const bunch = sampleBunch(12);
		const { berries, berry } = bunch;
		const surfaces = surfacesOf(bunch);
		if (!surfaces || !berry) throw new Error("nothing to draw");
		const vertices = berry.positions.length / 3;
		expect(surfaces.pressed).toEqual(new Uint8Array(vertices * berries.count));
		for (let i = 0; i < berries.count; i++) {
			const centre = new Vector3().fromArray(berries.spheres, 4 * i);
			const axis = new Vector3().fromArray(berries.directions, 3 * i);
			for (let v = 0; v < vertices; v += 7) {
				const from = new Vector3().fromArray(surfaces.positions, 3 * (i * vertices + v)).sub(centre);
				const normal = new Vector3().fromArray(surfaces.normals, 3 * (i * vertices + v));
				expect(from.length()).toBeCloseTo(berries.spheres[4 * i + 3], 6);
				expect(from.normalize().dot(normal)).toBeCloseTo(1, 5);
				expect(axis.dot(normal)).toBeCloseTo(berry.normals[3 * v + 1], 5);
			}
		}
	});

	it("turns and never mirrors, whichever way the berry hangs", () => {
		const component = evenly(-1, 1);
		fc.assert(
			fc.property(component, component, component, (x, y, z) => {
				const direction = new Vector3(x, y, z);
				fc.pre(direction.length() > 0.1);
				const bunch = sampleBunch(1);
				bunch.berries.directions.set(direction.normalize().toArray());
				bunch.berry = {
					positions: new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1]),
					normals: new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1]),
					uvs: new Float32Array(6),
					indices: new Uint32Array([0, 1, 2]),
				};
				const [a, b, c] = [0, 3, 6].map((at) => new Vector3().fromArray(surfacesOf(bunch)?.normals ?? [], at));
				expect(b.distanceTo(direction)).toBeLessThan(0.02);
				expect(a.cross(b).dot(c)).toBeCloseTo(1, 4);
			}),
		);
	});

	it("is undefined if only the skeleton was requested", () => {
		expect(surfacesOf({ ...sampleBunch(3), berry: undefined })).toBeUndefined();
	});
});

describe("packVertices", () => {
	const bunch = pressedBunch({ count: 9 });
	if (!bunch.surfaces) throw new Error("no surfaces");
	const surfaces = { ...bunch.surfaces, sky: bunch.surfaces.pressed.map((_, i) => (7 * i) % 256) };

	it("keeps places to a micrometre, `pressed` and `sky` to the byte and normals to a hundredth of a degree", () => {
		const words = new Uint32Array(4 * surfaces.pressed.length);
		const reaches = packVertices(surfaces, bunch.berries, words);
		const vertices = surfaces.uvs.length / 2;
		for (let v = 0; v < surfaces.pressed.length; v++) {
			const berry = Math.floor(v / vertices);
			const at = [...halves(words[4 * v]), halves(words[4 * v + 1])[0]];
			for (let k = 0; k < 3; k++) {
				const place = bunch.berries.spheres[4 * berry + k] + reaches[berry] * at[k];
				expect(Math.abs(place - surfaces.positions[3 * v + k])).toBeLessThan(1e-6);
			}
			expect((words[4 * v + 1] >>> 16) & 0xff).toBe(surfaces.pressed[v]);
			expect(words[4 * v + 1] >>> 24).toBe(surfaces.sky[v]);
			const normal = new Vector3().fromArray(surfaces.normals, 3 * v).normalize();
			expect(unpacked(words[4 * v + 2]).angleTo(normal)).toBeLessThan(Math.PI / 180 / 100);
		}
	});

	it("treats all of the sky as visible if it was not computed", () => {
		const words = new Uint32Array(4 * surfaces.pressed.length);
		packVertices({ ...surfaces, sky: undefined }, bunch.berries, words);
		expect(words[1] >>> 24).toBe(255);
	});
});

describe("skiesOf", () => {
	const bunch = pressedBunch({ count: 3 });
	if (!bunch.surfaces) throw new Error("no surfaces");
	const { surfaces } = bunch;
	const vertices = surfaces.uvs.length / 2;

	it("returns each berry's mean", () => {
		const sky = new Uint8Array(3 * vertices);
		sky.fill(51, vertices, 2 * vertices);
		sky[vertices] = 255;
		const skies = skiesOf({ ...surfaces, sky }, 3);
		expect(skies[0]).toBe(0);
		expect(skies[1]).toBeCloseTo(0.2 + 0.8 / vertices, 5);
		expect([...skiesOf(surfaces, 3)]).toEqual([1, 1, 1]);
	});
});

/** Unpacks a word like the vertex shader. */
function halves(word: number): [number, number] {
	return [((word & 0xffff) / 65535) * 2 - 1, ((word >>> 16) / 65535) * 2 - 1];
}

function unpacked(word: number): Vector3 {
	const [x, y] = halves(word);
	const n = new Vector3(x, y, 1 - Math.abs(x) - Math.abs(y));
	const below = Math.max(-n.z, 0);
	n.x -= below * (n.x < 0 ? -1 : 1);
	n.y -= below * (n.y < 0 ? -1 : 1);
	return n.normalize();
}
