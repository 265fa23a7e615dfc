import fc from "fast-check";
import { type BufferAttribute, Color, Matrix4, type Mesh, type MeshPhysicalMaterial, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { Grown } from "../../../web/src/core/grown";
import { canInstance, exportGlb, type GlbOptions } from "../../../web/src/export/glb";
import { MEASURE_KEYS } from "../../../web/src/specimen/measures.generated";
import type { Look, Specimen } from "../../../web/src/specimen/specimen";
import * as arbitrary from "./arbitrary";
import { makeGrown, SKETCH, sampleSpecimen } from "./fixture";
import { makeNatural } from "./natural_fixture";
import { complaints, documentOf, load, meshesOf } from "./reading";

const grown = makeNatural(SKETCH);
const specimen = sampleSpecimen({ preset: "short-conical", seed: 7 });
const FORMS: GlbOptions[] = [{}, { compact: true }, { instancing: true }, { compact: true, instancing: true }];

const aged = (age: number): Specimen => ({ ...specimen, parameters: { ...specimen.parameters, age } });
const looking = (look: Partial<Look>): Specimen => ({ ...specimen, look: { ...specimen.look, ...look } });

async function read(from: Grown, of: Specimen = specimen, options?: GlbOptions) {
	const { scene } = await load(await exportGlb(from, of, options));
	scene.updateMatrixWorld(true);
	const meshes = meshesOf(scene);
	const named = (start: string) => meshes.filter(({ userData }) => userData.name?.startsWith(start));
	return { scene, meshes, named, skin: named("Berry ")[0]?.material as MeshPhysicalMaterial };
}

const at = (mesh: Mesh, vertex: number) =>
	new Vector3().fromBufferAttribute(mesh.geometry.attributes.position, vertex).applyMatrix4(mesh.matrixWorld);

/** What a viewer shows at a vertex, in linear light. */
function shade(mesh: Mesh, vertex: number): Color {
	const { color } = mesh.geometry.attributes;
	const tint = new Color(color.getX(vertex), color.getY(vertex), color.getZ(vertex));
	return tint.multiply((mesh.material as MeshPhysicalMaterial).color);
}

const brightness = ({ r, g, b }: Color) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

describe("the GLB of a natural bunch", () => {
	it("gives Khronos' validator nothing to say, in any form, for any growth, age and look", async () => {
		const trait = fc.double({ min: 0, max: 1, noNaN: true });
		const traits = fc.record({ exposure: trait, turned: trait, opened: trait, set: trait, shrivel: trait });
		const fruit = fc.constantFrom("grape", "currant", "bramble", "lychee", "longan", "duku") as fc.Arbitrary<
			Grown["form"]["fruit"]
		>;
		await fc.assert(
			fc.asyncProperty(
				arbitrary.sketch,
				arbitrary.specimen,
				traits,
				fruit,
				fc.constantFrom(...FORMS),
				fc.boolean(),
				async (sketch, any, all, kind, form, bare) => {
					const natural = makeNatural(sketch, { traits: () => all, bare });
					natural.form = { ...natural.form, fruit: kind };
					expect(await complaints(await exportGlb(natural, any, form))).toEqual([]);
				},
			),
			{ numRuns: 120 },
		);
	}, 60_000);

	it("names everything, and gives each berry a mesh of its own", async () => {
		const { nodes, meshes, materials } = documentOf(await exportGlb(grown, specimen));
		const names = (indices: number[] = []) => indices.map((index) => nodes[index].name);
		expect(names(nodes[0].children)).toEqual(
			"Rachis,Axis 01,Axis 02,Axis 03,Berries,Cane,Petiole 1,Leaf 1,Petiole 2,Leaf 2".split(","),
		);
		expect(names(nodes.find(({ name }) => name === "Berries")?.children)).toEqual([
			"Berry 001",
			"Berry 002",
			"Berry 003",
		]);
		expect(meshes?.filter(({ name }) => name.startsWith("Berry ")).map(({ name }) => name)).toHaveLength(3);
		expect(materials?.map(({ name }) => name)).toEqual(["Stem", "Skin", "Cane", "Petiole", "Leaf"]);
	});

	it.each([{ compact: false }, { compact: true }])("puts every vertex where the growth has it (%o)", async (form) => {
		const { named } = await read(grown, specimen, form);
		const { positions = new Float32Array(), normals = positions, uvs = positions } = grown.surfaces ?? {};
		const vertices = uvs.length / 2;
		named("Berry ").forEach((berry, i) => {
			const radius = grown.berries.spheres[4 * i + 3];
			for (let vertex = 0; vertex < vertices; vertex++) {
				const from = 3 * (i * vertices + vertex);
				const place = new Vector3(...positions.subarray(from, from + 3));
				expect(at(berry, vertex).distanceTo(place)).toBeLessThan(form.compact ? radius / 10_000 : 1e-8);
				const normal = new Vector3().fromBufferAttribute(berry.geometry.attributes.normal, vertex);
				const error = normal.distanceTo(new Vector3(...normals.subarray(from, from + 3)));
				expect(error).toBeLessThan(form.compact ? 0.008 : 1e-6);
			}
		});
		const corners = [...named("Rachis"), ...named("Axis ")].flatMap((mesh) =>
			Array.from({ length: mesh.geometry.attributes.position.count }, (_, vertex) => at(mesh, vertex)),
		);
		corners.forEach((corner, i) => {
			const expected = new Vector3(...(grown.stem?.positions.subarray(3 * i, 3 * i + 3) ?? []));
			expect(corner.distanceTo(expected)).toBeLessThan(1e-6);
		});
	});

	it("stands each berry's node at its centre, so that it can be moved", async () => {
		for (const compact of [false, true]) {
			const { nodes } = documentOf(await exportGlb(grown, specimen, { compact }));
			nodes
				.filter(({ name }) => name.startsWith("Berry "))
				.forEach(({ translation = [] }, i) => {
					expect(Float32Array.from(translation)).toEqual(grown.berries.spheres.slice(4 * i, 4 * i + 3));
				});
		}
	});

	it("writes texture coordinates and triangles of the pattern once", async () => {
		const { meshes } = documentOf(await exportGlb(grown, specimen));
		const berries = meshes?.filter(({ name }) => name.startsWith("Berry ")).map(({ primitives }) => primitives[0]);
		expect(new Set(berries?.map(({ indices }) => indices)).size).toBe(1);
		expect(new Set(berries?.map(({ attributes }) => attributes.TEXCOORD_0)).size).toBe(1);
		expect(new Set(berries?.map(({ attributes }) => attributes.POSITION)).size).toBe(3);
		expect(new Set(berries?.map(({ material }) => material)).size).toBe(1);
		const { named } = await read(grown);
		const [one, other] = named("Berry ").map(({ geometry }) => geometry);
		expect((one.index as BufferAttribute).array.buffer).toBe((other.index as BufferAttribute).array.buffer);
	});

	it("says of each berry what is known of it", async () => {
		const { named } = await read(grown);
		named("Berry ").forEach(({ userData }, i) => {
			const pedicel = grown.berries.parent[i];
			expect(userData).toMatchObject({ id: grown.berries.ids[i], pedicel, axis: grown.internodes.axis[pedicel] });
			const [width, length, exposure, turned] = grown.berries.traits.subarray(8 * i);
			const said = [userData.radius, userData.width, userData.length, userData.exposure, userData.turned];
			expect(said.map(Math.fround)).toEqual([grown.berries.spheres[4 * i + 3], width, length, exposure, turned]);
		});
	});

	it("has the measures by key in asset.extras", async () => {
		const { extras } = documentOf(await exportGlb(grown, specimen)).asset;
		expect(Object.keys(extras.measures as object)).toEqual(MEASURE_KEYS);
		expect(extras).toMatchObject({ procedure: "natural", fingerprint: grown.fingerprint });
	});

	it("is much smaller when compact, and says that readers must know how", async () => {
		const fine = makeNatural({ ...SKETCH, segments: 24, sides: 7 });
		const [full, compact] = await Promise.all([
			exportGlb(fine, specimen),
			exportGlb(fine, specimen, { compact: true }),
		]);
		const { extensionsRequired } = documentOf(compact);
		expect(extensionsRequired).toEqual(["KHR_mesh_quantization"]);
		expect(documentOf(full).extensionsRequired).toBeUndefined();
		const vertices = (fine.surfaces?.positions.length ?? 0) / 3;
		expect(full.length - compact.length).toBeGreaterThan(10 * vertices);
	});

	it("cannot be drawn as instances of one berry, and is written as ever where that is asked for", async () => {
		expect([canInstance(grown), canInstance(makeGrown(SKETCH))]).toEqual([false, true]);
		expect(await exportGlb(grown, specimen, { instancing: true })).toEqual(await exportGlb(grown, specimen));
	});
});

describe("the colours of a natural bunch", () => {
	const seat = 0;

	it("darken a base that is as bright as the brightest vertex", async () => {
		const { named } = await read(grown);
		const brightest = [0, 0, 0];
		for (const { geometry } of named("Berry ")) {
			const { color } = geometry.attributes;
			for (let i = 0; i < color.count; i++) {
				[color.getX(i), color.getY(i), color.getZ(i)].forEach((value, k) => {
					brightest[k] = Math.max(brightest[k], value);
				});
			}
		}
		expect(brightest).toEqual([1, 1, 1]);
	});

	it("go from the unripe to the ripe colour as berries turn", async () => {
		const plain = looking({ bloom: 0, uneven: 0, unripe: "8ea552", skin: "43264f" });
		const { named } = await read(makeNatural(SKETCH, { traits: (i) => ({ turned: i / 2 }) }), plain);
		const [unripe, turning, ripe] = named("Berry ").map((mesh) => shade(mesh, mesh.geometry.attributes.uv.count >> 1));
		const near = (colour: Color, hex: string) => {
			const [r, g, b] = new Color(`#${hex}`).toArray();
			expect(Math.hypot(colour.r - r, colour.g - g, colour.b - b)).toBeLessThan(0.02);
		};
		near(unripe, "8ea552");
		near(ripe, "43264f");
		// Half turned: redder than green, not yet as dark.
		expect(turning.r).toBeGreaterThan(turning.g);
		expect(brightness(turning)).toBeGreaterThan(brightness(ripe));
	});

	it("lose the wax where berries touch, brown the scar, and differ from berry to berry", async () => {
		const { named } = await read(grown, looking({ bloom: 1, skin: "1d1c30" }));
		const berry = named("Berry ")[0];
		const { pressed = new Uint8Array() } = grown.surfaces ?? {};
		const { uv } = berry.geometry.attributes;
		const middle = Array.from({ length: uv.count }, (_, i) => i).filter((i) => Math.abs(uv.getY(i) - 0.5) < 0.2);
		const mean = (touching: boolean) => {
			const those = middle.filter((i) => pressed[i] > 0 === touching).map((i) => brightness(shade(berry, i)));
			return those.reduce((sum, each) => sum + each, 0) / those.length;
		};
		expect(mean(false)).toBeGreaterThan(1.3 * mean(true));
		const bare = await read(grown, looking({ bloom: 0, uneven: 1, skin: "c9a25a" }));
		const [one, other] = bare.named("Berry ");
		expect(shade(one, middle[0]).getHex()).not.toBe(shade(other, middle[0]).getHex());
		expect(brightness(shade(one, uv.count - 1))).toBeLessThan(0.6 * brightness(shade(one, seat)));
	});

	it("turn stems to wood with age, the rachis first", async () => {
		const redness = async (age: number, name: string) => {
			const [mesh] = (await read(grown, aged(age))).named(name);
			const { r, g } = shade(mesh, 0);
			return r / g;
		};
		expect(await redness(100, "Rachis")).toBeGreaterThan(1.1 * (await redness(20, "Rachis")));
		expect(await redness(100, "Rachis")).toBeGreaterThan(await redness(100, "Axis 01"));
		expect(await redness(125, "Axis 01")).toBeGreaterThan(await redness(100, "Axis 01"));
	});
});

describe("the materials of a natural bunch, as three.js reads them", () => {
	it("are of a bloomed, dark grape: sheen, a dull mirror, no light through it", async () => {
		const { skin } = await read(grown, looking({ skin: "33254a", bloom: 0.8 }));
		expect(skin.ior).toBe(1.4);
		expect(skin.sheen * skin.sheenColor.b).toBeGreaterThan(0.1);
		expect(skin.specularIntensity).toBeCloseTo(0.6);
		expect([skin.transmission, skin.clearcoat]).toEqual([0, 0.05]);
	});

	it("are of a pale grape: a little light passes, coloured by the flesh", async () => {
		const { skin } = await read(grown, looking({ skin: "c9cf86", glow: 1, bloom: 0 }));
		expect(skin.transmission).toBeGreaterThan(0.1);
		expect(skin.transmission).toBeLessThanOrEqual(0.3);
		expect(skin.thickness).toBeCloseTo(grown.berries.traits[0], 2);
		expect(skin.attenuationColor.b).toBeLessThan(skin.attenuationColor.g);
		expect(skin.side).toBe(0);
		const opaque = await read(grown, looking({ skin: "c9cf86", glow: 0 }));
		expect(opaque.skin.transmission).toBe(0);
	});

	it("are of a clean currant: a clear coat; of a rind: neither coat nor light", async () => {
		const of = (fruit: Grown["form"]["fruit"]) => ({ ...grown, form: { ...grown.form, fruit } });
		const currant = await read(of("currant"), looking({ skin: "b8121c", bloom: 0 }));
		expect(currant.skin.clearcoat).toBeCloseTo(0.9);
		const rind = await read(of("lychee"), looking({ skin: "d3b778", bloom: 0, glow: 1 }));
		expect([rind.skin.clearcoat ?? 0, rind.skin.transmission ?? 0]).toEqual([0, 0]);
		expect(rind.skin.roughness).toBeGreaterThan(0.7);
	});

	it("show leaves from both sides, green and then yellow", async () => {
		const leaf = async (age: number) =>
			(await read(grown, aged(age))).named("Leaf ")[0].material as MeshPhysicalMaterial;
		const [green, late] = [await leaf(80), await leaf(125)];
		expect(green.side).toBe(2);
		expect(green.color.g).toBeGreaterThan(green.color.r);
		expect(late.color.r).toBeGreaterThan(green.color.r);
	});
});

describe("the flowers of a natural bunch", () => {
	const blooming = makeNatural(SKETCH, {
		traits: (i) => ({ turned: 0, opened: i === 0 ? 0 : 1, set: i === 2 ? 0.5 : 0 }),
	});

	it.each([{ compact: false }, { compact: true }])("share a mesh and hang on their berries (%o)", async (form) => {
		const { named } = await read(blooming, specimen, form);
		const flowers = named("Flower ");
		// The first is a closed bud.
		expect(flowers.map(({ userData, parent }) => [userData.name, parent?.userData.name])).toEqual([
			["Flower 002", "Berry 002"],
			["Flower 003", "Berry 003"],
		]);
		expect(new Set(flowers.map(({ geometry }) => geometry)).size).toBe(1);
		flowers.forEach(({ matrixWorld, geometry }, k) => {
			const i = k + 1;
			const [x, y, z, r] = blooming.berries.spheres.subarray(4 * i);
			expect(new Vector3().setFromMatrixPosition(matrixWorld).distanceTo(new Vector3(x, y, z))).toBeLessThan(1e-7);
			const up = new Vector3(0, 1, 0).applyMatrix4(new Matrix4().extractRotation(matrixWorld));
			expect(up.distanceTo(new Vector3(...blooming.berries.directions.subarray(3 * i, 3 * i + 3)))).toBeLessThan(1e-6);
			const reach = new Vector3().fromBufferAttribute(geometry.attributes.position, 0).length();
			const share = i === 2 ? 0.5 : 1;
			expect(reach * new Vector3().setFromMatrixScale(matrixWorld).x).toBeCloseTo(share * r, 6);
		});
	});

	it("have white filaments and yellow anthers, and are gone when all have set", async () => {
		const [flower] = (await read(blooming)).named("Flower ");
		const { uv } = flower.geometry.attributes;
		const blue = (anther: boolean) =>
			shade(flower, Array.from({ length: uv.count }, (_, i) => i).find((i) => uv.getY(i) > 0.5 === anther) ?? -1).b;
		expect(blue(true)).toBeLessThan(0.5 * blue(false));
		const set = documentOf(await exportGlb(grown, specimen));
		expect([...set.nodes, ...(set.meshes ?? [])].filter(({ name }) => name.startsWith("Flower"))).toEqual([]);
		expect(set.materials?.map(({ name }) => name)).not.toContain("Stamen");
	});
});
