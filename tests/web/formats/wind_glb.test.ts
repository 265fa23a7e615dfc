/** Plants in the wind as GLBs: judged by Khronos' validator, played by three.js, compared with how the view moves them. */
import { AnimationMixer, type Mesh, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { windGlb } from "../../../web/src/formats/wind_glb";
import { swayed } from "../../../web/src/generate/files/swayed";
import { swing } from "../../../web/src/plant/point_sway";
import { PERIOD, type Sway } from "../../../web/src/plant/sway";
import { grownParts } from "./grown_parts";
import { complaints, documentOf, load, meshesOf } from "./reading";
import { ABOUT, fruits, PULP, tetrahedron } from "./toy_parts";

const SWAY: Sway = { foot: [0, 0, 0], up: 1, height: 2, reach: 1 };

/** Where every vertex is. */
function placesOf(meshes: readonly Mesh[]): Vector3[] {
	return meshes.flatMap((mesh) => {
		mesh.updateWorldMatrix(true, false);
		return Array.from({ length: mesh.geometry.attributes.position.count }, (_, i) =>
			mesh.getVertexPosition(i, new Vector3()).applyMatrix4(mesh.matrixWorld),
		);
	});
}

/** A file as three.js plays it. */
async function played(glb: Uint8Array) {
	const { scene, animations } = await load(glb);
	const mixer = new AnimationMixer(scene);
	mixer.clipAction(animations[0]).play();
	return {
		animations,
		at: (seconds: number) => {
			mixer.setTime(seconds);
			return placesOf(meshesOf(scene));
		},
		rest: () => placesOf(meshesOf(scene)),
	};
}

describe("the wind form", () => {
	it("moves every vertex where the view has it, and round without a seam", async () => {
		const leaf = { mesh: tetrahedron([0, 0, 0], 0.1), material: PULP };
		const transforms = Float32Array.of(0.3, 1.5, 0.2, 0, 0, 0, 1, 1);
		const parts = [
			{ name: "Fruit", shape: { mesh: tetrahedron([0.2, 1, 0], 0.5), material: PULP } },
			{ name: "Leaf", shape: { ...leaf, instances: { transforms } } },
		];
		const glb = await windGlb(parts, ABOUT, SWAY);
		expect(await complaints(glb)).toEqual([]);
		expect(documentOf(glb).extensionsRequired).toBeUndefined();
		const { animations, rest, at } = await played(glb);
		expect(animations.map(({ name, duration }) => [name, duration])).toEqual([["Wind", PERIOD]]);
		const still = rest();
		const foot = new Vector3(0.3, 1.5, 0.2);
		const held = (place: Vector3) => (place.distanceTo(foot) < 0.2 ? foot : place);
		for (const [share, s, c] of [
			[0.25, 1, 0],
			[0.5, 0, -1],
			[0.75, -1, 0],
		]) {
			const now = at(PERIOD * share);
			for (const [i, place] of still.entries()) {
				const { sine, cosine } = swing(SWAY, place.toArray(), held(place).toArray());
				const there = place.toArray().map((value, k) => value + s * sine[k] + c * cosine[k]);
				expect(now[i].distanceTo(new Vector3(...there))).toBeLessThan(1e-6);
			}
		}
		const [first, last] = [at(0), at(PERIOD - 1e-6)];
		expect(Math.max(...first.map((place, i) => place.distanceTo(last[i])))).toBeLessThan(1e-4);
	});

	it("leaves stone where it is", async () => {
		const stone = { ...PULP, still: true } as const;
		const parts = [{ name: "Wall", shape: { mesh: tetrahedron([0.2, 1, 0], 0.5), material: stone } }];
		const { rest, at } = await played(await windGlb(parts, ABOUT, SWAY));
		const still = rest();
		expect(Math.max(...at(PERIOD / 4).map((place, i) => place.distanceTo(still[i])))).toBe(0);
	});

	it("is the plant at rest where nothing plays, and without animation where nothing sways", async () => {
		const swaying = await load(await windGlb(fruits(), ABOUT, SWAY));
		const still = await load(await windGlb(fruits(), ABOUT, undefined));
		expect([swaying.animations.length, still.animations.length]).toEqual([1, 0]);
		const [one, other] = [placesOf(meshesOf(swaying.scene)), placesOf(meshesOf(still.scene))];
		expect(Math.max(...one.map((place, i) => place.distanceTo(other[i])))).toBe(0);
	});
});

describe.each([
	["growth/table-1-sigma1", { steps: 8 }],
	["bunch/riesling", {}],
])("%s in the wind", (source, changed) => {
	it("takes 6 MB at the most, and its foot stands still while its top moves", async () => {
		const { model, specimen, core, parts, about } = await grownParts(source, changed);
		const grown = model.read(core.grow(model.encode(specimen, { meshes: false })), specimen);
		const sway = swayed(model, grown) as Sway;
		const glb = await windGlb(parts(), about, sway);
		expect(glb.length).toBeLessThan(6e6);
		const { rest, at } = await played(glb);
		const [still, now] = [rest(), at(PERIOD / 4)];
		const moved = still.map((place, i) => ({
			height: (sway.up * (place.y - sway.foot[1])) / sway.height,
			by: place.distanceTo(now[i]) / sway.height,
		}));
		expect(Math.max(...moved.filter(({ height }) => height < 0.02).map(({ by }) => by))).toBeLessThan(0.002);
		expect(Math.max(...moved.map(({ by }) => by))).toBeGreaterThan(0.015);
	});
});

it("a root stands still", async () => {
	const { model } = await grownParts("root/carrot", { n: 40 });
	expect(swayed(model, {} as Parameters<typeof swayed>[1])).toBeUndefined();
});
