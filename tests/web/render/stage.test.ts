import { Object3D, type PerspectiveCamera } from "three";
import { describe, expect, it, vi } from "vitest";
import { rigOf } from "../../../web/src/render/light";
import type { ModelRenderer, RendererStage } from "../../../web/src/render/model_renderer";
import { outdoorRig } from "../../../web/src/render/outdoor/outdoor_light";
import { Stage } from "../../../web/src/render/stage";

/** A renderer that logs its calls. */
function fakeRenderer() {
	const calls: string[] = [];
	let stage: RendererStage | undefined;
	const object = new Object3D();
	const make = (given: RendererStage): ModelRenderer<string, number> => {
		stage = given;
		given.root.add(object);
		return {
			show: (grown, specimen) => calls.push(`show ${grown} ${specimen}`),
			bounds: () => ({ spheres: Float32Array.from([0, 0, 0, 1]), points: new Float32Array(0) }),
			prepare: vi.fn((_: PerspectiveCamera) => undefined),
			pick: () => 7,
			mark: (picked) => calls.push(`mark ${picked}`),
			modes: ["whole", "bare"],
			setMode: (mode) => calls.push(`mode ${mode}`),
			dispose: () => {
				object.removeFromParent();
				calls.push("dispose");
			},
		};
	};
	return { make, calls, object, given: () => stage as RendererStage };
}

const RAY = { origin: [0, 0, 1], direction: [0, 0, -1] } as const;

describe("Stage", () => {
	it("shows plants by its renderer, and returns the bounds", () => {
		const { make, calls } = fakeRenderer();
		const stage = new Stage<string, number>();
		stage.use(make);
		expect(stage.filled).toBe(false);
		expect(stage.pick(RAY)).toBeUndefined();
		expect(stage.show(3, "seed").spheres).toHaveLength(4);
		expect([stage.filled, stage.pick(RAY), ...calls]).toEqual([true, 7, "show 3 seed"]);
	});

	it("throws an error with a remedy if there is no renderer", () => {
		expect(() => new Stage<string, number>().show(1, "a")).toThrow("give the viewer one to use");
	});

	it("disposes of the previous renderer", () => {
		const [one, other] = [fakeRenderer(), fakeRenderer()];
		const stage = new Stage<string, number>();
		stage.use(one.make);
		stage.show(1, "a");
		const behind = stage.scene.children.length;
		stage.use(other.make);
		expect(stage.scene.children).toHaveLength(behind);
		expect(stage.scene.children).not.toContain(one.given().root);
		expect(one.calls.at(-1)).toBe("dispose");
		expect(one.object.parent).toBeNull();
		expect(stage.filled).toBe(false);
		expect(other.given().root.visible).toBe(false);
		stage.show(2, "b");
		expect(other.given().root.visible).toBe(true);
	});

	it("is outdoors only while that is wanted and the renderer has a light for it", () => {
		const stage = new Stage<string, number>();
		const { make, given } = fakeRenderer();
		stage.setOutdoors(true);
		stage.use(make);
		expect(given().setting.outdoors).toBe(false);
		stage.use((own) => ({ ...make(own), outdoorRig, groundLevel: 2 }));
		expect(given().setting.outdoors).toBe(true);
		expect(given().light.rig.fixed).toBe(true);
		expect(stage.groundLevel).toBe(2);
		stage.setTheme("dark");
		expect(given().setting.theme).toBe("dark");
		stage.setOutdoors(false);
		expect(given().setting.outdoors).toBe(false);
		expect(given().light.rig).toBe(rigOf("dark"));
		expect(stage.groundLevel).toBeUndefined();
	});

	it("draws the plant alone while the background is flat", () => {
		const stage = new Stage<string, number>();
		const { make, given } = fakeRenderer();
		stage.use(make);
		stage.setGround(1);
		expect(given().setting.bare).toBe(true);
		stage.setGround();
		expect(given().setting.bare).toBe(false);
	});

	it("shows the plant without editing aids and marks during a call, and shows them again afterwards", () => {
		const { make, calls, given } = fakeRenderer();
		const stage = new Stage<string, number>();
		stage.use(make);
		stage.show(1, "a");
		stage.mark(4);
		const aid = new Object3D();
		stage.aids.add(aid);
		const shown = () => {
			const objects: Object3D[] = [];
			stage.scene.traverseVisible((object) => objects.push(object));
			return [aid, given().root].map((object) => objects.includes(object));
		};
		expect(shown()).toEqual([true, true]);
		expect(stage.plantAlone(shown)).toEqual([false, true]);
		expect(shown()).toEqual([true, true]);
		expect(calls.slice(-3)).toEqual(["mark 4", "mark undefined", "mark 4"]);
		expect(() =>
			stage.plantAlone(() => {
				throw new Error("lost");
			}),
		).toThrow("lost");
		expect(shown()).toEqual([true, true]);
	});

	it("passes on changed marks and existing modes only; a new plant has no mark", () => {
		const { make, calls } = fakeRenderer();
		const stage = new Stage<string, number>();
		stage.use(make);
		stage.show(1, "a");
		const changed = [stage.mark(4), stage.mark(4), stage.setMode("bare"), stage.setMode("bare"), stage.setMode("cut")];
		expect(changed).toEqual([true, false, true, false, false]);
		stage.show(2, "a");
		expect(stage.mark(4)).toBe(true);
		expect(calls).toEqual(["show 1 a", "mark 4", "mode bare", "show 2 a", "mark 4"]);
	});
});
