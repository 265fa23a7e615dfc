import { describe, expect, it } from "vitest";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../web/src/specimen/specimen";
import { apply } from "../../../web/src/ui/change";
import type { HandleVector, PlantHandle, PlantHandles } from "../../../web/src/ui/handles/plant_handle";
import { inRun } from "../../long_run.mjs";

const models = (await Promise.all(modelNames().map(modelNamed))).filter(({ handles }) => handles);
/**
 * Of each model's presets that have handles to be dragged at once (growth areas are chosen before: areas/edits.test.ts) the first two and the
 * last two, in the gate the last alone: a spline, other forms, leaves with and without lobes.
 */
const cases = (
	await Promise.all(
		models.map(async (model) => {
			const handlesOf = await model.handles?.();
			const handled = model.presets.list.filter(({ name }) => {
				const specimen = fromPreset(model, name);
				const handles = handlesOf?.(specimen, specimen)?.handles ?? [];
				return handles.length > 1 && handles.every(({ along }) => along.length > 0);
			});
			return [...handled.slice(0, inRun(0, 2)), ...handled.slice(-inRun(1, 2))].map(({ name }) => ({
				model,
				preset: name,
				of: model.name,
			}));
		}),
	)
).flat();

const plus = (a: HandleVector, way: HandleVector, by: number): HandleVector => [
	a[0] + by * way[0],
	a[1] + by * way[1],
	a[2] + by * way[2],
];
const minus = (a: HandleVector, b: HandleVector): HandleVector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const far = (a: HandleVector, b: HandleVector) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
/** How large the plant is by its handles and lines. */
function sizeOf({ handles, lines }: PlantHandles): number {
	const places = [...handles.map(({ at }) => at), ...lines.flat()];
	return Math.max(
		...[0, 1, 2].map((k) => Math.max(...places.map((at) => at[k])) - Math.min(...places.map((at) => at[k]))),
	);
}
const dot = (a: HandleVector, b: HandleVector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

describe.each(cases)("the handles of $of $preset", ({ model, preset }) => {
	const specimen = fromPreset(model, preset);
	const of = async (now: Specimen) => (await model.handles?.())?.(now, specimen) as PlantHandles;
	const same = (set: PlantHandles, { id }: PlantHandle) => set.handles.find((each) => each.id === id) as PlantHandle;

	it("are there, each with a name, a value and ways of its own", async () => {
		const { handles, lines } = await of(specimen);
		expect(handles.length).toBeGreaterThan(1);
		expect(new Set(handles.map(({ id }) => id)).size).toBe(handles.length);
		// Growth areas show theirs once one is chosen.
		if (model.name !== "grammar") expect(lines.flat().length).toBeGreaterThan(3);
		for (const { label, value, along } of handles) {
			expect(label).toMatch(/^[A-Z]/);
			expect(value).toMatch(/\S/);
			for (const way of along) expect(Math.hypot(...way)).toBeCloseTo(1, 6);
			if (along.length === 2) expect(dot(along[0], along[1])).toBeCloseTo(0, 6);
		}
	});

	/** A leaf has many that are much alike. */
	const few = (handles: readonly PlantHandle[]) => handles.filter((_, i) => i % Math.ceil(handles.length / 10) === 0);

	it("stay where they are when they are taken nowhere, and change nothing else", async () => {
		const set = await of(specimen);
		for (const handle of few(set.handles)) {
			const again = await of(apply(model, specimen, handle.pull(handle.at)));
			expect(far(same(again, handle).at, handle.at)).toBeLessThan(0.012 * sizeOf(set));
		}
	});

	it("follow a hand some of the way along one of their ways, and arrow keys", async () => {
		const set = await of(specimen);
		// Less than that of some is none, and more than that is at their ends.
		const steps = [0.015, 0.04, 0.09, 0.15].map((share) => share * sizeOf(set));
		for (const handle of few(set.handles)) {
			const goes = handle.along.flatMap((way) => steps.flatMap((step) => [step, -step].map((by) => ({ way, by }))));
			const followed = await Promise.all(
				goes.map(async ({ way, by }) => {
					const moved = same(await of(apply(model, specimen, handle.pull(plus(handle.at, way, by)))), handle);
					// Some are led along a line of their own, and come with part of the way.
					return moved && dot(minus(moved.at, handle.at), way) / by > 0.25;
				}),
			);
			expect(followed, handle.label).toContain(true);
			const pressed = [[1, 0], [-1, 0], [0, 1], [0, -1]].map(([x, y]) => apply(model, specimen, handle.nudge(x, y, true))); // biome-ignore format: four arrows
			const stepped = await Promise.all(pressed.map(async (now) => same(await of(now), handle)));
			expect(
				stepped.some((moved) => moved && far(moved.at, handle.at) > 0.002 * sizeOf(set)),
				handle.label,
			).toBe(true);
		}
	});
});
