import { beforeEach, describe, expect, it } from "vitest";
import type { Studio } from "../../../../../web/src/app/studio";
import { mirror, sides, toggleLock } from "../../../../../web/src/models/bunch/ui/sides";
import { bunchContext, studioWith } from "../../../app/context";
import { specimenFromPreset } from "../../../bunch";

const opened = specimenFromPreset("grape-15c");

describe("the two sides of a pair", () => {
	let studio: Studio;
	let remembered: () => unknown;
	const parameters = () => studio.state.specimen.parameters;

	beforeEach(async () => {
		const { studio: fresh, services } = await studioWith(opened);
		studio = fresh;
		remembered = () => services.remember.mock.lastCall?.[0].tools.bunch;
	});

	it.each([
		["leftRight", "p3", "p4"],
		["frontBack", "p5", "p6"],
	] as const)("%s: locked, come together at once, and undoing that is one step", (pair, from, to) => {
		toggleLock(bunchContext(studio), pair);
		expect([parameters()[`${to}w`], parameters()[`${to}r`]]).toEqual([
			parameters()[`${from}w`],
			parameters()[`${from}r`],
		]);
		studio.edit({ parameters: { [`${from}w`]: 111 } });
		expect(parameters()[`${to}w`]).toBe(111);
		studio.settle();
		studio.undo();
		studio.undo();
		expect(studio.state.specimen).toEqual(opened);
		expect(studio.toolState(sides)[pair]).toBe(true);
		expect(remembered()).toMatchObject({ sides: { [pair]: true } });
		toggleLock(bunchContext(studio), pair);
		expect(studio.state.specimen).toEqual(opened);
	});

	it("complete a change of one side, and leave a change of both alone", () => {
		studio.setToolState(sides, { leftRight: true, frontBack: true });
		studio.set({ parameters: { p4w: 77, p5r: 88 } });
		expect([parameters().p3w, parameters().p4w, parameters().p5r, parameters().p6r]).toEqual([77, 77, 88, 88]);
		expect(parameters().p3r).toBe(opened.parameters.p3r);
		studio.set({ parameters: { p3w: 10, p4w: 20 } });
		expect([parameters().p3w, parameters().p4w]).toEqual([10, 20]);
	});

	it.each([
		["leftRight", "p3", "p4"],
		["frontBack", "p5", "p6"],
	] as const)("%s: mirrored as one step, locked or not", (pair, a, b) => {
		studio.setToolState(sides, { leftRight: true, frontBack: true });
		const before = opened.parameters;
		mirror(bunchContext(studio), pair);
		expect(parameters()).toEqual({
			...before,
			[`${a}w`]: before[`${b}w`],
			[`${a}r`]: before[`${b}r`],
			[`${b}w`]: before[`${a}w`],
			[`${b}r`]: before[`${a}r`],
		});
		studio.undo();
		expect(studio.state.specimen).toEqual(opened);
	});

	it.each([undefined, null, 3, "x", [], { leftRight: 1 }])("are free where %j was remembered", (stored) => {
		expect(sides.recall?.(stored)).toEqual({ leftRight: false, frontBack: false });
	});
});
