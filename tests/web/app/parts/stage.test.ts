import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { StagePart } from "../../../../web/src/app/parts/stage";
import { Studio } from "../../../../web/src/app/studio";
import { specimenFromPreset } from "../../bunch";
import { sampleBunch } from "../../models/bunch/sample_bunch";
import { studioWith } from "../context";

const solid = vi.hoisted(() => ({ update: vi.fn(), resize: vi.fn(), dispose: vi.fn() }));
vi.mock("../../../../web/src/app/solid_view", () => ({ SolidView: { create: async () => solid } }));

/** Reports another width to the observer of an element. */
let resized: (width: number) => void;
let studio: Studio;
let stage: StagePart;
/** The functions that end its subscriptions. */
let left: (() => void)[];
beforeEach(async () => {
	vi.stubGlobal(
		"ResizeObserver",
		class {
			observe() {}
			disconnect() {}
			constructor(callback: (entries: unknown[]) => void) {
				resized = (width) => callback([{ contentRect: { width } }]);
			}
		},
	);
	vi.stubGlobal("navigator", {});
	({ studio } = await studioWith(specimenFromPreset()));
	left = [];
	vi.spyOn(studio, "subscribe").mockImplementation((listener) => {
		const leave = vi.fn(Studio.prototype.subscribe.call(studio, listener));
		left.push(leave);
		return leave;
	});
	stage = new StagePart();
	Object.assign(stage, { querySelector: () => ({}), querySelectorAll: () => [], performUpdate: () => {} });
	Object.defineProperty(stage, "isConnected", { value: true });
	stage.context = studio;
	stage.connectedCallback();
	(stage as unknown as { updated(): void }).updated();
	await task();
	vi.clearAllMocks();
});
afterEach(() => {
	stage.disconnectedCallback();
	vi.unstubAllGlobals();
});

const task = () => new Promise((resolve) => setTimeout(resolve));
const grow = () => studio.grew(sampleBunch(5), studio.state.specimen);

it("updates the view in a task of its own, once for several changes", async () => {
	grow();
	studio.setUi({ theme: "dark" });
	for (let i = 0; i < 9; i++) await Promise.resolve();
	expect(solid.update).not.toHaveBeenCalled();
	await task();
	expect(solid.update.mock.calls).toEqual([[studio.state]]);
	grow();
	await task();
	expect(solid.update).toHaveBeenCalledTimes(2);
});

it("draws nothing while hidden, and updates when visible again", async () => {
	resized(0);
	grow();
	await task();
	expect(solid.update).not.toHaveBeenCalled();
	resized(300);
	await task();
	expect(solid.update.mock.calls).toEqual([[studio.state]]);
});

it("ends its subscriptions when it leaves the page", async () => {
	stage.disconnectedCallback();
	expect(left).toHaveLength(2);
	for (const leave of left) expect(leave).toHaveBeenCalled();
	grow();
	await task();
	expect(solid.update).not.toHaveBeenCalled();
});

it("shows the plant again when it comes back to the page", async () => {
	stage.disconnectedCallback();
	stage.connectedCallback();
	(stage as unknown as { updated(): void }).updated();
	await task();
	expect(solid.update.mock.calls).toEqual([[studio.state]]);
});
