import { readFile } from "node:fs/promises";
import { Group, Mesh, type MeshStandardMaterial, PerspectiveCamera } from "three";
import { beforeAll, describe, expect, it, vi } from "vitest";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import type { Leaf } from "../../../../web/src/models/leaf/grown";
import { model } from "../../../../web/src/models/leaf/index";
import { FacePictures, PREVIEW_SIDE } from "../../../../web/src/models/leaf/parts/face_pictures";
import { leafParts } from "../../../../web/src/models/leaf/parts/leaf_parts";
import { LeafRenderer } from "../../../../web/src/models/leaf/render/leaf_renderer";
import {
	type BladeTextures,
	type PaintedLeaf,
	Painter,
	type PaintOrder,
} from "../../../../web/src/models/leaf/render/paint";
import { PaintQueue, type PaintWorker } from "../../../../web/src/models/leaf/render/paint_queue";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";
import { rgbaPicture } from "../../../../web/src/plant/picture";
import { PAPER } from "../../../../web/src/render/model_renderer";
import { PaperShadow } from "../../../../web/src/render/paper_shadow";
import { StageLight } from "../../../../web/src/render/stage_light";
import { windUniforms } from "../../../../web/src/render/wind_shader";

const specimen = leafFromPreset("willow");
specimen.parameters.n = 300;
const autumn = { ...specimen, look: { ...specimen.look, autumn: 0.7 } };
let leaf: Leaf;
let running: Leaf;
beforeAll(async () => {
	const core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
	leaf = model.read(core.grow(model.encode(specimen)));
	const young = { ...specimen, parameters: { ...specimen.parameters, age: 60 } };
	running = model.read(core.grow(model.encode(young, { preview: true })));
});

/** A worker that answers each order when the test calls `work`. */
class Bench implements PaintWorker {
	onmessage: PaintWorker["onmessage"] = null;
	onerror: PaintWorker["onerror"] = null;
	readonly orders: PaintOrder[] = [];
	ended = false;
	readonly #painter = new Painter();
	postMessage(order: PaintOrder): void {
		this.orders.push(structuredClone(order));
	}
	terminate(): void {
		this.ended = true;
	}
	/** Answers the next order. */
	work(): void {
		const order = this.orders.shift() as PaintOrder;
		const data: PaintedLeaf = { ...this.#painter.paint(order), id: order.id };
		this.onmessage?.call(this as unknown as Worker, { data } as MessageEvent<PaintedLeaf>);
	}
	break(): void {
		this.onerror?.call(this as unknown as Worker, { preventDefault: () => {} } as ErrorEvent);
	}
}

interface Shown {
	width: number;
	data: Uint8Array;
}

/** Comparing such arrays number by number takes minutes. */
const same = (one: Uint8Array, other: Uint8Array) => Buffer.from(one).equals(other);

/** The textures of a face in files. */
function written(of: Leaf, side: "upper" | "lower", as = specimen) {
	const part = [...leafParts(of, as)].find(({ name }) => name === `Blade, ${side} face`);
	const { colour, normal } = part?.shape?.material.textures ?? {};
	if (!colour || !normal) throw new Error("The face has no pictures.");
	return { colour: rgbaPicture(colour).pixels, normal: rgbaPicture(normal).pixels };
}

const coarse = (of: Leaf, side: "upper" | "lower") =>
	new FacePictures(of, specimen.parameters.length, PREVIEW_SIDE, true).face(specimen, side).colour;

function staged() {
	const bench = new Bench();
	const changed = vi.fn();
	const root = new Group();
	const stage = {
		root,
		light: new StageLight(),
		shadow: new PaperShadow(),
		wind: windUniforms(),
		setting: PAPER,
		changed,
	};
	const figure = new LeafRenderer(stage, (deliver) => new PaintQueue(deliver, () => bench));
	const drawn = (side: "upper" | "lower") => {
		const face = root.children.find((one): one is Mesh => one instanceof Mesh && one.name.includes(side));
		const worn = face?.material as MeshStandardMaterial | undefined;
		return { colour: worn?.map?.image as Shown, normal: worn?.normalMap?.image as Shown };
	};
	return { bench, changed, figure, drawn };
}
const camera = new PerspectiveCamera();

describe("a leaf on the stage", () => {
	it("is shown coarse at once, and with the pictures of its files once they are painted, one a frame", () => {
		const { bench, changed, figure, drawn } = staged();
		figure.show(leaf, specimen);
		expect(drawn("upper").colour.width).toBe(256);
		expect(drawn("upper").normal.width).toBe(1);
		bench.work();
		expect(changed).toHaveBeenCalledTimes(1);
		expect(drawn("upper").colour.width).toBe(256);
		const widths = () =>
			(["upper", "lower"] as const).flatMap((side) => [drawn(side).colour.width, drawn(side).normal.width]);
		const fine = [];
		for (let frame = 0; frame < 5; frame++) {
			fine.push(widths().filter((width) => width === 1024).length);
			figure.prepare(camera);
		}
		expect(fine).toEqual([0, 1, 2, 3, 4]);
		for (const side of ["upper", "lower"] as const) {
			expect(same(drawn(side).colour.data, written(leaf, side).colour)).toBe(true);
			expect(same(drawn(side).normal.data, written(leaf, side).normal)).toBe(true);
		}
	});

	it("keeps its fine pictures while other colours are painted, and draws no vein anew for them", async () => {
		const { bench, figure, drawn } = staged();
		figure.show(leaf, specimen);
		bench.work();
		await figure.whenFinished();
		figure.show(leaf, autumn);
		expect(drawn("upper").colour.width).toBe(1024);
		expect(bench.orders[0].leaf).toBeUndefined();
		bench.work();
		await figure.whenFinished();
		expect(same(drawn("upper").colour.data, written(leaf, "upper", autumn).colour)).toBe(true);
		expect(same(drawn("upper").colour.data, written(leaf, "upper").colour)).toBe(false);
	});

	it("shows the last textures in previews until its own are painted, with fewer pixels and no relief", async () => {
		const { bench, changed, figure, drawn } = staged();
		figure.show(leaf, specimen);
		bench.work();
		await figure.whenFinished();
		const fine = drawn("upper").colour;
		figure.show(running, specimen);
		expect(drawn("upper").colour === fine).toBe(true);
		changed.mockClear();
		bench.work();
		expect(changed).toHaveBeenCalledTimes(1);
		for (const side of ["upper", "lower"] as const) {
			expect([drawn(side).colour.width, drawn(side).normal.width]).toEqual([256, 1]);
			expect(same(drawn(side).colour.data, rgbaPicture(coarse(running, side)).pixels)).toBe(true);
		}
		const { colour, normal } = drawn("upper");
		figure.show({ ...running }, specimen);
		bench.work();
		expect(drawn("upper").normal === normal).toBe(true);
		expect(drawn("upper").colour === colour).toBe(false);
		const last = drawn("upper").colour;
		figure.show(leaf, specimen);
		expect(drawn("upper").colour === last).toBe(true);
	});

	it("is painted at once where no similar textures exist, also in previews", () => {
		const { figure, drawn } = staged();
		figure.show(running, specimen);
		const passed = drawn("upper").colour;
		expect(same(passed.data, rgbaPicture(coarse(running, "upper")).pixels)).toBe(true);
		figure.show({ ...running }, { ...specimen, preset: "oak" });
		expect(drawn("upper").colour === passed).toBe(false);
	});

	it("does not mix the textures of previews and final leaves", () => {
		const { bench, changed, figure, drawn } = staged();
		figure.show(leaf, specimen);
		figure.show(running, specimen);
		bench.work();
		expect(changed).not.toHaveBeenCalled();
		figure.show(leaf, specimen);
		bench.work();
		expect(changed).not.toHaveBeenCalled();
		bench.work();
		figure.prepare(camera);
		expect(drawn("upper").colour.width).toBe(1024);
	});
});

describe("the paint queue", () => {
	it("has one order under way, and of those that wait the newest", () => {
		const bench = new Bench();
		const delivered: BladeTextures[] = [];
		const commission = new PaintQueue(
			(faces) => delivered.push(faces),
			() => bench,
		);
		commission.order(leaf, specimen);
		for (const uneven of [0.1, 0.2, 0.3]) commission.order(leaf, { ...specimen, look: { ...specimen.look, uneven } });
		expect(bench.orders).toHaveLength(1);
		bench.work();
		expect(delivered).toHaveLength(0);
		expect(bench.orders.map(({ specimen: { look } }) => look.uneven)).toEqual([0.3]);
		bench.work();
		expect(delivered).toHaveLength(1);
	});

	it("delivers outdated textures during previews, since none would arrive while leaves change faster than they are painted", () => {
		const bench = new Bench();
		const delivered: boolean[] = [];
		const commission = new PaintQueue(
			(_, preview) => delivered.push(preview),
			() => bench,
		);
		for (let i = 0; i < 3; i++) commission.order({ ...running }, specimen, true);
		bench.work();
		expect(delivered).toEqual([true]);
		bench.work();
		expect(delivered).toEqual([true, true]);
	});

	it("paints on the page's thread when an order cannot be cloned", async () => {
		const bench = new Bench();
		vi.spyOn(bench, "postMessage").mockImplementation(() => void structuredClone({ uncloneable: () => {} }));
		const delivered: BladeTextures[] = [];
		const commission = new PaintQueue(
			(faces) => delivered.push(faces),
			() => bench,
		);
		commission.order(leaf, specimen);
		await commission.whenDone();
		expect(bench.ended).toBe(true);
		expect(delivered).toHaveLength(1);
	});

	it("paints in the page where no worker can be had", async () => {
		const bench = new Bench();
		const delivered: BladeTextures[] = [];
		const commission = new PaintQueue(
			(faces) => delivered.push(faces),
			() => bench,
		);
		commission.order(leaf, specimen);
		const done = commission.whenDone();
		bench.break();
		await done;
		expect(bench.ended).toBe(true);
		commission.order(leaf, autumn);
		expect(delivered).toHaveLength(2);
		expect(same(delivered[1].upper.colour.pixels, written(leaf, "upper", autumn).colour)).toBe(true);
	});
});
