import {
	DoubleSide,
	Group,
	type InstancedBufferGeometry,
	type InstancedMesh,
	type Mesh,
	type MeshStandardMaterial,
	PerspectiveCamera,
	type ShaderMaterial,
	type Texture,
	Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { bunchParts } from "../../../../../web/src/models/bunch/parts/bunch_parts";
import { bunchSkin } from "../../../../../web/src/models/bunch/parts/skin";
import { AMBER, HALO, SCAR, SEAT, WAX } from "../../../../../web/src/models/bunch/parts/skin_rules";
import { bunchRenderer } from "../../../../../web/src/models/bunch/render/bunch_renderer";
import { everyPart } from "../../../../../web/src/plant/part";
import { PAPER } from "../../../../../web/src/render/model_renderer";
import { PaperShadow } from "../../../../../web/src/render/paper_shadow";
import { StageLight } from "../../../../../web/src/render/stage_light";
import { windUniforms } from "../../../../../web/src/render/wind_shader";
import { SKETCH } from "../fixture";
import { makeNatural } from "../natural_fixture";
import { pressedBunch } from "../pressed_bunch";
import { LOOK } from "../sample_bunch";

type Part = Mesh<InstancedBufferGeometry, ShaderMaterial>;

function staged(grown: BunchPlant) {
	const stage = {
		root: new Group(),
		light: new StageLight(),
		shadow: new PaperShadow(),
		wind: windUniforms(),
		setting: PAPER,
	};
	const figure = bunchRenderer(stage);
	figure.show(grown, { look: LOOK });
	const part = (name: string) => stage.root.getObjectByName(name) as Part;
	const camera = new PerspectiveCamera();
	camera.position.set(0, -0.05, 0.5);
	camera.updateMatrixWorld();
	return { stage, figure, part, camera };
}

const bunch = pressedBunch({ count: 60 });
const shadows = ({ root }: PaperShadow) => (root.children[0] as Part).geometry.instanceCount;

describe("the bunch's renderer", () => {
	it("shows berries and stems, and flowers and leaves where there are any", () => {
		const { part } = staged(bunch);
		expect(["berries", "stems", "foliage"].map((name) => part(name).visible)).toEqual([true, true, false]);
		expect(part("stamens")).toBeUndefined();
		const blooming = staged(makeNatural(SKETCH, { traits: () => ({ opened: 1, set: 0 }) }));
		expect(["stamens", "foliage"].map((name) => blooming.part(name).visible)).toEqual([true, true]);
		expect((blooming.part("stamens") as unknown as InstancedMesh).count).toBe(3);
	});

	it("knows berries by their ids, and has none to point at without them", () => {
		const { figure, part } = staged(bunch);
		const [x, y, z] = bunch.berries.spheres.subarray(4 * 7, 4 * 7 + 3);
		const [dx, dy, dz] = bunch.berries.directions.subarray(3 * 7, 3 * 7 + 3);
		// From outside, along the pedicel's own direction, it is the first or one that stands before it.
		const ray = { origin: [x + dx, y + dy, z + dz], direction: [-dx, -dy, -dz] } as const;
		const id = figure.pick(ray) as number;
		expect([...bunch.berries.ids]).toContain(id);
		const { highlighted } = part("berries").material.uniforms;
		figure.mark(id);
		expect(bunch.berries.ids[highlighted.value]).toBe(id);
		figure.mark(4_000_000);
		expect(highlighted.value).toBe(-1);
		figure.mark(id);
		figure.show(bunch, { look: LOOK });
		expect(highlighted.value).toBe(-1);
		figure.setMode("stems");
		expect(figure.pick(ray)).toBeUndefined();
	});

	it("hides the berries and their shadows in the mode of stems, for later bunches too", () => {
		const { stage, figure, part } = staged(bunch);
		const whole = shadows(stage.shadow);
		figure.setMode("stems");
		const bare = () => [part("berries").visible, shadows(stage.shadow)];
		expect(bare()).toEqual([false, bunch.internodes.count]);
		figure.show(bunch, { look: LOOK });
		expect(bare()).toEqual([false, bunch.internodes.count]);
		figure.setMode("whole");
		expect([part("berries").visible, shadows(stage.shadow)]).toEqual([true, whole]);
	});

	it("draws the berry nearest the eye first", () => {
		const { stage, figure, part, camera } = staged(bunch);
		stage.light.aim(camera);
		figure.prepare(camera);
		const order = part("berries").geometry.getAttribute("nature");
		expect(part("berries").geometry.instanceCount).toBe(60);
		const away = (i: number) => {
			const at = 4 * order.getX(i);
			const [x, y, z] = bunch.berries.spheres.subarray(at, at + 3);
			return Math.hypot(x, y + 0.05, z - 0.5);
		};
		expect(away(0)).toBeLessThan(away(30));
		expect(away(30)).toBeLessThan(away(59));
	});

	it("paints veins on leaves as in files, again only when they or the season change", () => {
		const green = makeNatural(SKETCH);
		const { foliage } = green;
		if (!foliage) throw new Error("no foliage");
		const veins = { side: 2, shares: Uint8Array.of(0, 255, 0, 128) };
		const veined: BunchPlant = { ...green, foliage: { ...foliage, veins } };
		const { figure, part } = staged(green);
		const leaf = () => {
			const materials = [part("foliage").material].flat() as unknown as MeshStandardMaterial[];
			return materials.find(({ name }) => name === "Leaf") as MeshStandardMaterial;
		};
		expect(leaf().map).toBeNull();
		figure.show(veined, { look: LOOK });
		const drawn = leaf().map;
		const exported = [...bunchParts(veined, { look: LOOK })].find(({ name }) => name === "Leaf 1")?.shape?.material;
		const { data } = (drawn as Texture).image as unknown as { data: Uint8Array };
		expect([...data.filter((_, at) => at % 4 < 3)]).toEqual([...(exported?.textures?.colour?.pixels ?? [])]);
		figure.show({ ...veined }, { look: LOOK });
		expect(leaf().map).toBe(drawn);
		const soon = makeNatural(SKETCH, { traits: () => ({ shrivel: 0.001 }) });
		figure.show({ ...soon, foliage: veined.foliage }, { look: LOOK });
		expect(leaf().map).toBe(drawn);
		const late = makeNatural(SKETCH, { traits: () => ({ shrivel: 1 }) });
		figure.show({ ...late, foliage: veined.foliage }, { look: LOOK });
		expect(leaf().map).not.toBe(drawn);
		figure.show(green, { look: LOOK });
		expect(leaf().map).toBeNull();
	});

	it("draws the same colours of stems and leaves, rules of skins and values as files have", () => {
		const grown = makeNatural(SKETCH, { traits: () => ({ opened: 1, set: 0, shrivel: 0.8 }) });
		const { part } = staged(grown);
		const parts = [...everyPart(bunchParts(grown, { look: LOOK }))];
		const colourOf = (name: string, count: number) =>
			(part(name).geometry.getAttribute("color").array as Float32Array).subarray(0, count);
		for (const name of ["stems", "foliage"] as const) {
			const mesh = name === "stems" ? grown.stem : grown.foliage;
			const written = parts
				.filter(({ shape }) => (shape?.material.name === "Stem") === (name === "stems"))
				.filter(({ shape }) => ["Stem", "Leaf", "Cane", "Petiole"].includes(shape?.material.name ?? ""))
				.flatMap(({ shape }) => [...(shape?.mesh.colours ?? [])]);
			expect(written.length).toBeGreaterThan(9);
			expect([...colourOf(name, mesh?.positions.length ?? 0)]).toEqual(written);
		}
		const drawn = [part("stems").material, part("stamens").material, ...[part("foliage").material].flat()];
		for (const { name, roughness, side } of drawn as unknown as MeshStandardMaterial[]) {
			const exported = parts.find(({ shape }) => shape?.material.name === name)?.shape?.material;
			if (exported)
				expect({ name, roughness, double: side === DoubleSide }).toEqual({
					name,
					roughness: exported.roughness,
					double: exported.doubleSided ?? false,
				});
		}
		const skin = bunchSkin(grown, { look: LOOK });
		const { uniforms, vertexShader, fragmentShader } = part("berries").material;
		expect([uniforms.scar.value, uniforms.bloom.value, uniforms.uneven.value]).toEqual([
			skin.fruit.scar,
			skin.bloom,
			skin.uneven,
		]);
		expect(uniforms.wax.value.toArray()).toEqual(skin.wax);
		// The edge of the scar, the wax's depth, the seat's colour: the rules' own numbers.
		for (const number of AMBER.colour) expect(vertexShader).toContain(String(number));
		for (const number of [SCAR.edge, HALO.width, WAX.depth, ...SEAT.colour])
			expect(fragmentShader).toContain(String(number));
	});

	it("gives the shader the same direction of the sun as files", () => {
		const grown = pressedBunch({ count: 3, exposure: 0.25 });
		const look = { ...LOOK, skin: "c4bd66" };
		const parameters = { sun: 90, sun_height: 30, sunlight: 0.5 };
		const { figure, part, camera } = staged(grown);
		figure.show(grown, { look, parameters });
		figure.prepare(camera);
		const { uniforms } = part("berries").material;
		const { towards, amber } = bunchSkin(grown, { look, parameters }).sunned;
		expect(amber).toBeGreaterThan(0.3);
		expect(uniforms.amber.value).toBe(amber);
		expect(uniforms.sunward.value.toArray()).toEqual(towards);
		expect(towards[0]).toBeCloseTo(Math.cos(Math.PI / 6), 6);
		expect(towards[1]).toBeCloseTo(0.5, 6);
		expect(part("berries").geometry.getAttribute("nature").getZ(0)).toBe(0.25);
	});

	it("marks withered pedicels on bare stems, under an open sky", () => {
		const grown = { ...bunch, internodes: { ...bunch.internodes, state: bunch.internodes.state.slice() } };
		const withered = grown.internodes.count - 1;
		grown.internodes.state[withered] = 1;
		const { figure, part } = staged(grown);
		const vertex = grown.stem?.internode.indexOf(withered) ?? -1;
		expect(vertex).toBeGreaterThanOrEqual(0);
		const look = () => {
			const { geometry } = part("stems");
			const at = (name: string) => new Vector3().fromBufferAttribute(geometry.getAttribute(name), vertex);
			return {
				redness: at("color").x / at("color").y,
				place: at("position"),
				sky: geometry.getAttribute("sky").getX(vertex),
			};
		};
		const among = look();
		figure.setMode("stems");
		const bare = look();
		expect(among.redness).toBeLessThan(4);
		expect(bare.redness).toBeGreaterThan(10);
		expect(bare.place.distanceTo(among.place)).toBeGreaterThan(0);
		expect(bare.sky).toBe(1);
		figure.setMode("whole");
		expect(look()).toEqual(among);
	});

	it("is held by the view with its leaves", () => {
		const grown = makeNatural(SKETCH);
		const { figure } = staged(grown);
		const { spheres, points } = figure.bounds();
		expect(spheres).toBe(grown.berries.spheres);
		expect(points.length).toBeGreaterThan(grown.internodes.ends.length);
		expect(points.length).toBeLessThan(grown.internodes.ends.length + (grown.foliage?.positions.length ?? 0));
	});

	it("takes everything off the stage when it goes", () => {
		const { stage, figure } = staged(bunch);
		figure.dispose();
		expect([stage.root.children, stage.shadow.root.children]).toEqual([[], []]);
	});
});
