import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { SolidView } from "../../../web/src/app/solid_view";
import type { Studio } from "../../../web/src/app/studio";
import type { PageModel } from "../../../web/src/models/page_model";
import { specimenFromPreset } from "../bunch";
import { sampleBunch } from "../models/bunch/sample_bunch";
import { toy } from "../toy";
import { bunchModel, studioWith } from "./context";

/** A mock of the viewer, without a graphics card. */
const view = vi.hoisted(() => ({
	use: vi.fn(),
	show: vi.fn(),
	holdView: vi.fn(),
	setTheme: vi.fn(),
	orbit: vi.fn(),
	pan: vi.fn(),
	zoom: vi.fn(),
	resetView: vi.fn(),
	resize: vi.fn(),
	pick: vi.fn(() => 7),
	mark: vi.fn(),
	setMode: vi.fn(),
	addOverlay: vi.fn(),
	removeOverlay: vi.fn(),
	requestRender: vi.fn(),
	snapshot: vi.fn(),
	dispose: vi.fn(),
	modes: ["whole", "stems"],
	orbiting: true,
	reducedMotion: true,
	camera: {},
	options: undefined as unknown,
}));
vi.mock("../../../web/src/render/viewer", () => ({
	Viewer: class {
		constructor(_canvas: unknown, options: unknown) {
			view.options = options;
			// biome-ignore lint/correctness/noConstructorReturn: the one fake is looked at by the tests.
			return view;
		}
	},
}));

const canvas = () => {
	const classes = { toggle: vi.fn(), remove: vi.fn() };
	const stub = { classList: classes, clientWidth: 400, clientHeight: 300 };
	return { ...stub, addEventListener: vi.fn(), removeEventListener: vi.fn() } as unknown as HTMLCanvasElement;
};
const events = { lost: vi.fn(), restored: vi.fn(), motion: vi.fn() };
const grown = sampleBunch(5);

describe("the 3-D view", () => {
	let studio: Studio;
	let motion: EventTarget;
	let solid: SolidView;
	beforeEach(async () => {
		vi.clearAllMocks();
		motion = new EventTarget();
		vi.stubGlobal("matchMedia", () => Object.assign(motion, { matches: true }));
		({ studio } = await studioWith(specimenFromPreset()));
		solid = await SolidView.create(canvas(), studio, events);
	});
	afterEach(() => vi.unstubAllGlobals());

	const update = () => solid.update(studio.state);

	it("starts with the model's renderer, the page's theme and the motion preference", () => {
		expect(view.use).toHaveBeenCalledTimes(1);
		expect(view.options).toMatchObject({ reducedMotion: true, theme: "light" });
	});

	it("follows changes of the motion preference until it is disposed", () => {
		motion.dispatchEvent(Object.assign(new Event("change"), { matches: false }));
		expect(view.reducedMotion).toBe(false);
		solid.dispose();
		motion.dispatchEvent(Object.assign(new Event("change"), { matches: true }));
		expect(view.reducedMotion).toBe(false);
	});

	it("shows a plant once, and again after a change of colour without growing", () => {
		update();
		expect(view.show).not.toHaveBeenCalled();
		studio.grew(grown, studio.state.specimen);
		update();
		update();
		expect(view.show).toHaveBeenCalledTimes(1);
		studio.set({ look: { skin: "112233" } });
		update();
		expect(view.show).toHaveBeenCalledTimes(2);
		expect(view.show.mock.lastCall).toMatchObject([grown, { look: { skin: "112233" } }]);
	});

	it("does not show a plant again while its life plays on", () => {
		studio.grew(grown, studio.state.specimen);
		update();
		studio.edit({ parameters: { age: 20 } });
		update();
		expect(view.show).toHaveBeenCalledTimes(1);
	});

	it("shows a tool's plant instead of the document's from the same camera position, but not in pictures", async () => {
		const { specimen } = studio.state;
		const other = sampleBunch(3);
		studio.grew(grown, specimen);
		update();
		solid.showSubstitute({ grown: other, from: specimen });
		expect(view.show.mock.lastCall?.[0]).toBe(other);
		expect(view.holdView.mock.lastCall).toEqual([true]);
		update();
		expect(view.show).toHaveBeenCalledTimes(2);
		view.snapshot.mockImplementation(async () => expect(view.show.mock.lastCall?.[0]).toBe(grown));
		await solid.picture();
		expect(view.snapshot).toHaveBeenCalled();
		expect(view.show.mock.lastCall?.[0]).toBe(other);
		solid.showSubstitute(undefined);
		expect(view.show.mock.lastCall?.[0]).toBe(grown);
		expect(view.holdView.mock.lastCall).toEqual([false]);
	});

	it("takes overlapping pictures of the document's plant, and shows the tool's plant after the last", async () => {
		const { specimen } = studio.state;
		const other = sampleBunch(3);
		studio.grew(grown, specimen);
		update();
		solid.showSubstitute({ grown: other, from: specimen });
		const finish: (() => void)[] = [];
		const take = () => new Promise<void>((resolve) => finish.push(resolve));
		view.snapshot.mockImplementationOnce(take).mockImplementationOnce(take);
		const [first, second] = [solid.picture(), solid.picture()];
		finish[0]();
		await first;
		update();
		expect(view.show.mock.lastCall?.[0]).toBe(grown);
		finish[1]();
		await second;
		expect(view.show.mock.lastCall?.[0]).toBe(other);
	});

	it("updates to the current state before taking a picture", async () => {
		studio.grew(grown, studio.state.specimen);
		await solid.picture();
		expect(view.show.mock.invocationCallOrder[0]).toBeLessThan(view.snapshot.mock.invocationCallOrder[0]);
	});

	it("does not move the camera during a drag", () => {
		update();
		expect(view.holdView.mock.lastCall).toEqual([false]);
		studio.edit({ parameters: { l: 300 } });
		expect(studio.state.held).toBe(true);
		update();
		expect(view.holdView.mock.lastCall).toEqual([true]);
		studio.settle();
		update();
		expect(view.holdView.mock.lastCall).toEqual([false]);
	});

	it("follows the theme", () => {
		update();
		studio.setUi({ theme: "dark" });
		update();
		update();
		expect(view.setTheme.mock.calls).toEqual([["light"], ["dark"]]);
	});

	it("turns, moves and zooms by the keys that the help lists, and no others", () => {
		const press = (key: string, shiftKey = false) => solid.press({ key, shiftKey } as KeyboardEvent);
		for (const key of ["ArrowRight", "ArrowLeft", "ArrowDown", "ArrowUp"]) expect(press(key)).toBe(true);
		const turns = view.orbit.mock.calls.map(([right, down]) => [Math.sign(right), Math.sign(down)]);
		expect(turns).toEqual([
			[1, 0],
			[-1, 0],
			[0, 1],
			[0, -1],
		]);
		press("ArrowRight", true);
		press("ArrowUp", true);
		expect(view.pan.mock.calls.map(([right, down]) => [Math.sign(right), Math.sign(down)])).toEqual([
			[1, 0],
			[0, -1],
		]);
		for (const key of ["+", "=", "-", "−"]) press(key);
		expect(view.zoom.mock.calls.map(([factor]) => factor > 1)).toEqual([true, true, false, false]);
		expect(press("0")).toBe(true);
		expect(view.resetView).toHaveBeenCalledTimes(1);
		expect(press("x")).toBe(false);
	});

	it("starts the tools' interactions with the canvas, and ends them with another model", async () => {
		studio.grew(grown, studio.state.specimen);
		update();
		const thin = studio.state.modelUi?.tools.find(({ name }) => name === "thinning");
		thin?.press?.(studio);
		update();
		expect(solid.pick(1, 2)).toBe(7);
		expect(view.mark).toHaveBeenCalled();
		view.mark.mockClear();
		studio.choosePreset("plain", toy as unknown as PageModel);
		update();
		studio.setUi({ theme: "dark" });
		update();
		expect(view.mark).not.toHaveBeenCalled();
	});

	it("loads another model's renderer before showing its plant, once", async () => {
		studio.grew(grown, studio.state.specimen);
		update();
		studio.choosePreset("plain", toy as unknown as PageModel);
		await vi.waitFor(() => expect(studio.state.modelUi).toBeDefined());
		view.use.mockClear();
		view.show.mockClear();
		const plant = { ...grown, measures: undefined };
		studio.grew(plant, studio.state.specimen);
		update();
		update();
		expect(view.show).not.toHaveBeenCalled();
		await vi.waitFor(() => expect(view.show).toHaveBeenCalledTimes(1));
		expect(view.use).toHaveBeenCalledTimes(1);
		expect(view.use.mock.invocationCallOrder[0]).toBeLessThan(view.show.mock.invocationCallOrder[0]);
		expect(bunchModel.name).not.toBe(studio.state.model.name);
	});

	it("fetches a renderer again after a failure only on request or after another model was shown", async () => {
		const render = vi.fn<() => Promise<never>>(() => Promise.reject(new TypeError("Failed to fetch")));
		const broken = { ...toy, render } as unknown as PageModel;
		studio.grew(grown, studio.state.specimen);
		const end = studio.subscribe(update);
		const notices = () => studio.state.notices.filter(({ title }) => title === "This plant cannot be drawn yet");
		studio.choosePreset("plain", broken);
		await vi.waitFor(() => expect(studio.state.modelUi).toBeDefined());
		const toyPlant = { ...grown, measures: undefined };
		studio.grew(toyPlant, studio.state.specimen);
		await vi.waitFor(() => expect(notices()).toHaveLength(1));
		for (let turn = 0; turn < 50; turn++) await Promise.resolve();
		studio.grew({ ...toyPlant }, studio.state.specimen);
		for (let turn = 0; turn < 50; turn++) await Promise.resolve();
		expect(render).toHaveBeenCalledTimes(1);
		notices()[0].again?.();
		await vi.waitFor(() => expect(render).toHaveBeenCalledTimes(2));
		for (let turn = 0; turn < 50; turn++) await Promise.resolve();
		studio.undo();
		studio.grew(grown, studio.state.specimen);
		studio.redo();
		studio.grew(toyPlant, studio.state.specimen);
		await vi.waitFor(() => expect(render).toHaveBeenCalledTimes(3));
		for (let turn = 0; turn < 50; turn++) await Promise.resolve();
		expect(render).toHaveBeenCalledTimes(3);
		end();
	});

	it("disposes the viewer when it is disposed", () => {
		update();
		solid.dispose();
		expect(view.dispose).toHaveBeenCalledTimes(1);
	});
});
