import { expect, it, vi } from "vitest";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { stems } from "../../../../../web/src/models/bunch/ui/stems";
import { mark, putBack, takeOff, thinning } from "../../../../../web/src/models/bunch/ui/thinning";
import { bunchContext, studioWith } from "../../../app/context";
import { MAX_THINNED, specimenFromPreset, thin, unthin } from "../../../bunch";

const opened = specimenFromPreset("grape-15c");

it("removes berries one step each, and restores them all as one step", async () => {
	const { studio, services } = await studioWith(opened);
	const context = bunchContext(studio);
	const thinned = () => context.state.specimen.thinned;
	takeOff(context, 7, 9);
	expect(context.toolState(thinning).marked).toBe(9);
	takeOff(context, 3);
	expect(context.toolState(thinning).marked).toBeUndefined();
	expect(thinned()).toEqual([7, 3]);
	expect(services.grow.mock.lastCall?.[1]).toMatchObject({ thinned: [7, 3] });
	putBack(context);
	expect(thinned()).toEqual([]);
	studio.undo();
	expect(thinned()).toEqual([7, 3]);
	studio.undo();
	expect(thinned()).toEqual([7]);
	expect(services.settled.mock.lastCall?.[1]).toMatchObject({ thinned: [7] });
});

it("takes no more berries off than a link can hold, and none twice", () => {
	let specimen = opened;
	for (let id = 0; id < MAX_THINNED; id++) specimen = thin(specimen, id);
	expect(specimen.thinned).toHaveLength(MAX_THINNED);
	expect(thin(specimen, MAX_THINNED)).toBe(specimen);
	expect(thin(thin(opened, 7), 7).thinned).toEqual([7]);
	expect(unthin(specimen, 3).thinned).not.toContain(3);
});

it("is of natural bunches alone", () => {
	expect(thinning.applies?.(opened)).toBe(true);
	expect(thinning.applies?.(specimenFromPreset("grape-15c", 1))).toBe(false);
});

/** A canvas and a view that record their calls. */
function fakeView() {
	const listeners = new Map<string, (event: unknown) => void>();
	const classes = new Set<string>();
	const canvas = {
		addEventListener: (type: string, listener: (event: unknown) => void) => listeners.set(type, listener),
		removeEventListener: (type: string) => listeners.delete(type),
		getBoundingClientRect: () => ({ left: 100, top: 50 }),
		classList: { toggle: (name: string, on: boolean) => (on ? classes.add(name) : classes.delete(name)) },
	};
	const view = {
		canvas: canvas as unknown as HTMLCanvasElement,
		camera: {} as never,
		orbiting: true,
		keepWhole: vi.fn(),
		addOverlay: vi.fn(),
		removeOverlay: vi.fn(),
		requestRender: vi.fn(),
		pick: vi.fn((): number | undefined => 41),
		mark: vi.fn(),
		setMode: vi.fn(),
		rayThrough: vi.fn(),
		project: vi.fn(),
		onDrawn: vi.fn(),
		showSubstitute: vi.fn(),
		look: vi.fn(),
	};
	const send = (type: string, more: object = {}) =>
		listeners.get(type)?.({
			pointerId: 1,
			button: 0,
			buttons: 0,
			pointerType: "mouse",
			clientX: 130,
			clientY: 90,
			...more,
		});
	return { view, send, classes, listeners };
}

async function armed() {
	const { studio } = await studioWith(opened);
	const context = bunchContext(studio);
	studio.grew({ berries: { ids: Uint32Array.of(40, 41) } } as unknown as BunchPlant, opened);
	const fake = fakeView();
	const interaction = thinning.interaction?.(fake.view, context);
	if (!interaction) throw new Error("no interaction");
	const update = () => interaction.update(context.state);
	context.setToolState(thinning, { on: true, marked: undefined });
	update();
	return { studio, context, ...fake, interaction, update };
}

it("marks the berry under the pointer, and a click takes it off", async () => {
	const { context, view, send, update, classes } = await armed();
	expect(classes.has("thinning")).toBe(true);
	send("pointermove");
	expect(view.pick).toHaveBeenLastCalledWith(30, 40);
	expect(context.toolState(thinning).marked).toBe(41);
	update();
	expect(view.mark).toHaveBeenLastCalledWith(41);
	send("pointerdown");
	send("pointerup", { clientX: 133 });
	expect(context.state.specimen.thinned).toEqual([41]);
	mark(context, undefined);
	update();
	expect(view.mark).toHaveBeenLastCalledWith(undefined);
});

it("removes nothing when the pointer has moved, when another is down, or when a handle is held", async () => {
	const { context, view, send } = await armed();
	send("pointerdown");
	send("pointermove", { clientX: 160, buttons: 1 });
	send("pointerup");
	send("pointerdown");
	send("pointerdown", { pointerId: 2 });
	send("pointerup");
	send("pointerup", { pointerId: 2 });
	view.orbiting = false;
	send("pointerdown");
	view.orbiting = true;
	send("pointerup");
	expect(context.state.specimen.thinned).toEqual([]);
});

it("rests while the stems are shown alone, for the paper's bunches, and once its model has gone", async () => {
	const { context, send, update, classes, listeners, interaction } = await armed();
	const click = () => {
		send("pointerdown");
		send("pointerup");
	};
	context.setToolState(stems, true);
	update();
	click();
	expect([classes.has("thinning"), context.state.specimen.thinned]).toEqual([false, []]);
	context.setToolState(stems, false);
	context.set({ parameters: { procedure: 0 } });
	update();
	click();
	expect(context.state.specimen.thinned).toEqual([]);
	interaction.dispose();
	expect(listeners.size).toBe(0);
});
