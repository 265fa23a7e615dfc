import { PerspectiveCamera, Vector3 } from "three";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { handleVector } from "../../../../../web/src/models/bunch/profile/handle_ray";
import type { Handle } from "../../../../../web/src/models/bunch/profile/handles";
import { OctahedronHandles } from "../../../../../web/src/models/bunch/profile/octahedron";
import { DEFAULTS } from "./shape";

const WIDTH = 800;
const HEIGHT = 500;

type Listener = (event: unknown) => void;

/** Registered event listeners of the page and of the canvas. */
class Target {
	readonly #listeners = new Map<string, Set<Listener>>();
	addEventListener = (type: string, listener: Listener) => {
		const known = this.#listeners.get(type) ?? new Set();
		this.#listeners.set(type, known.add(listener));
	};
	removeEventListener = (type: string, listener: Listener) => this.#listeners.get(type)?.delete(listener);
	send(type: string, event: object) {
		for (const listener of [...(this.#listeners.get(type) ?? [])]) listener(event);
	}
	get listening(): number {
		return [...this.#listeners.values()].reduce((sum, { size }) => sum + size, 0);
	}
}

class Canvas extends Target {
	readonly style = { cursor: "" };
	readonly clientHeight = HEIGHT;
	setPointerCapture = vi.fn();
	getBoundingClientRect = () => ({ left: 0, top: 0, width: WIDTH, height: HEIGHT });
}

describe("the octahedron's handles", () => {
	const page = new Target();
	let frames: (() => void)[];
	let canvas: Canvas;
	let handles: OctahedronHandles;
	const host = { input: vi.fn(), change: vi.fn(), setControlsEnabled: vi.fn(), requestRender: vi.fn() };
	const camera = new PerspectiveCamera(24, WIDTH / HEIGHT, 0.01, 10);

	beforeEach(() => {
		vi.clearAllMocks();
		frames = [];
		vi.stubGlobal("window", page);
		vi.stubGlobal("requestAnimationFrame", (callback: () => void) => frames.push(callback));
		canvas = new Canvas();
		camera.position.set(0.1, -0.1, 0.9);
		camera.lookAt(new Vector3(0, -0.1, 0));
		camera.updateMatrixWorld();
		handles = new OctahedronHandles({
			...host,
			canvas: canvas as unknown as HTMLCanvasElement,
			camera,
			locks: () => ({ leftRight: false, frontBack: false }),
		});
		handles.update(DEFAULTS);
		handles.object.updateMatrixWorld();
	});
	afterEach(() => {
		handles.dispose();
		vi.unstubAllGlobals();
	});

	/** Returns a handle's position on the canvas. */
	const seen = (handle: Handle) => {
		const at = new Vector3(...handleVector(DEFAULTS, handle, DEFAULTS.unit)).project(camera);
		return { clientX: (0.5 + at.x / 2) * WIDTH, clientY: (0.5 - at.y / 2) * HEIGHT };
	};
	const pointer = (type: string, { clientX, clientY }: { clientX: number; clientY: number }, more = {}) =>
		canvas.send(type, { pointerId: 1, pointerType: "mouse", button: 0, buttons: 1, clientX, clientY, ...more });
	/** Grabs a handle and drags it by a number of canvas pixels. */
	const drag = (handle: Handle, right: number, down: number) => {
		const at = seen(handle);
		pointer("pointerdown", at);
		pointer("pointermove", { clientX: at.clientX + right, clientY: at.clientY + down });
		for (const frame of frames.splice(0)) frame();
		return { clientX: at.clientX + right, clientY: at.clientY + down };
	};

	it("widen the bunch to the right, live, and are one change when they are let go", () => {
		const end = drag("p3", 30, 0);
		expect(host.input).toHaveBeenCalledTimes(1);
		const [live] = host.input.mock.lastCall as [typeof DEFAULTS];
		expect(live.p3w).toBeGreaterThan(DEFAULTS.p3w + 5);
		expect(live.p4w).toBe(DEFAULTS.p4w);
		expect(host.change).not.toHaveBeenCalled();
		pointer("pointerup", end);
		expect(host.input).toHaveBeenCalledTimes(1);
		expect(host.change).toHaveBeenCalledTimes(1);
	});

	it("lengthen it downwards, ignoring sideways movement", () => {
		drag("p2", 40, 25);
		const [live] = host.input.mock.lastCall as [typeof DEFAULTS];
		expect(live.l).toBeGreaterThan(DEFAULTS.l + 5);
		expect({ ...live, l: DEFAULTS.l }).toEqual(DEFAULTS);
	});

	it("keep the bunch from turning while one is held, and only then", () => {
		const end = drag("p3", 10, 0);
		expect(host.setControlsEnabled.mock.calls).toEqual([[false]]);
		pointer("pointerup", end);
		expect(host.setControlsEnabled.mock.calls).toEqual([[false], [true]]);
	});

	it("return to their places at Escape, without passing the key on", () => {
		const end = drag("p3", 30, 10);
		const pressed = { key: "Escape", preventDefault: vi.fn(), stopPropagation: vi.fn() };
		page.send("keydown", { ...pressed, key: "a" });
		expect(host.change).not.toHaveBeenCalled();
		page.send("keydown", pressed);
		expect(pressed.preventDefault).toHaveBeenCalled();
		expect(pressed.stopPropagation).toHaveBeenCalled();
		expect(host.input.mock.lastCall).toEqual([DEFAULTS]);
		expect(host.setControlsEnabled.mock.lastCall).toEqual([true]);
		pointer("pointermove", { clientX: end.clientX + 50, clientY: end.clientY });
		pointer("pointerup", end);
		for (const frame of frames.splice(0)) frame();
		expect(host.change).toHaveBeenCalledTimes(1);
		expect(page.listening).toBe(0);
	});

	it("are found within a mouse's reach, and from further off by a thumb", () => {
		const { clientX, clientY } = seen("p3");
		const beside = { clientX: clientX + 20, clientY };
		pointer("pointerdown", beside);
		expect(host.setControlsEnabled).not.toHaveBeenCalled();
		pointer("pointerdown", beside, { pointerType: "touch" });
		expect(host.setControlsEnabled).toHaveBeenCalledWith(false);
	});

	it("are at the profile's positions", () => {
		const p5 = handles.object.getObjectByName("p5");
		expect(p5?.position.toArray()).toEqual([...handleVector(DEFAULTS, "p5", DEFAULTS.unit)]);
		handles.update({ ...DEFAULTS, p5w: DEFAULTS.p5w + 50 });
		expect(p5?.position.z).toBeGreaterThan(handleVector(DEFAULTS, "p5", DEFAULTS.unit)[2] + 0.01);
	});

	it("show under the mouse that they can be held", () => {
		pointer("pointermove", seen("p5"), { buttons: 0 });
		expect(canvas.style.cursor).toBe("grab");
		pointer("pointermove", { clientX: 2, clientY: 2 }, { buttons: 0 });
		expect(canvas.style.cursor).toBe("");
	});

	it("cannot be grabbed while hidden, are released when hidden, and clean up", () => {
		drag("p3", 30, 0);
		handles.setVisible(false);
		expect(host.input.mock.lastCall).toEqual([DEFAULTS]);
		expect(host.change).toHaveBeenCalledTimes(1);
		host.setControlsEnabled.mockClear();
		pointer("pointerdown", seen("p3"), { pointerId: 2 });
		expect(host.setControlsEnabled).not.toHaveBeenCalled();
		handles.dispose();
		expect(canvas.listening).toBe(0);
	});
});
