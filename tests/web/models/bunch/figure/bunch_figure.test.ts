import { Group, type InstancedBufferGeometry, type Mesh, PerspectiveCamera, type ShaderMaterial } from "three";
import { describe, expect, it } from "vitest";
import { bunchFigure } from "../../../../../web/src/models/bunch/figure/bunch_figure";
import type { Grown } from "../../../../../web/src/models/bunch/grown";
import { PaperShadow } from "../../../../../web/src/scene/paper_shadow";
import { StageLight } from "../../../../../web/src/scene/stage_light";
import { SKETCH } from "../fixture";
import { makeNatural } from "../natural_fixture";
import { pressedBunch } from "../pressed_bunch";
import { LOOK } from "../sample_bunch";

type Part = Mesh<InstancedBufferGeometry, ShaderMaterial>;

function staged(grown: Grown) {
	const stage = { root: new Group(), light: new StageLight(), shadow: new PaperShadow() };
	const figure = bunchFigure(stage);
	figure.show(grown, { look: LOOK });
	const part = (name: string) => stage.root.getObjectByName(name) as Part;
	const camera = new PerspectiveCamera();
	camera.position.set(0, -0.05, 0.5);
	camera.updateMatrixWorld();
	return { stage, figure, part, camera };
}

const bunch = pressedBunch({ count: 60 });
const shadows = ({ root }: PaperShadow) => (root.children[0] as Part).geometry.instanceCount;

describe("the bunch's figure", () => {
	it("shows berries and stems, and flowers and leaves where there are any", () => {
		const { part } = staged(bunch);
		expect(["berries", "stems", "flowers", "foliage"].map((name) => part(name).visible)).toEqual([
			true,
			true,
			false,
			false,
		]);
		expect(part("berries").geometry.instanceCount).toBe(60);
		const blooming = staged(makeNatural(SKETCH, { traits: () => ({ opened: 1, set: 0 }) }));
		expect(["flowers", "foliage"].map((name) => blooming.part(name).visible)).toEqual([true, true]);
		expect(blooming.part("flowers").geometry.instanceCount).toBe(3);
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

	it("leaves the berries and their shadows away where stems are asked for, of later bunches too", () => {
		const { stage, figure, part } = staged(bunch);
		const whole = shadows(stage.shadow);
		figure.setMode("stems");
		const bare = () => [part("berries").visible, part("stems").material.uniforms.marking.value, shadows(stage.shadow)];
		expect(bare()).toEqual([false, 1, bunch.internodes.count]);
		figure.show(bunch, { look: LOOK });
		expect(bare()).toEqual([false, 1, bunch.internodes.count]);
		figure.setMode("whole");
		expect([part("berries").visible, shadows(stage.shadow)]).toEqual([true, whole]);
	});

	it("draws the berry nearest the eye first", () => {
		const { stage, figure, part, camera } = staged(bunch);
		stage.light.aim(camera);
		figure.prepare(camera);
		const order = part("berries").geometry.getAttribute("receiver");
		const away = (i: number) => {
			const at = 4 * order.getX(i);
			const [x, y, z] = bunch.berries.spheres.subarray(at, at + 3);
			return Math.hypot(x, y + 0.05, z - 0.5);
		};
		expect(away(0)).toBeLessThan(away(30));
		expect(away(30)).toBeLessThan(away(59));
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
