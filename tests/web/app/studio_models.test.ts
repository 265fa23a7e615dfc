import { describe, expect, it, vi } from "vitest";
import { FIRST_VISIT } from "../../../web/src/app/ui_state";
import type { PageModel } from "../../../web/src/models/page_model";
import type { Plant } from "../../../web/src/plant/plant";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { specimenFromPreset } from "../bunch";
import { toy } from "../toy";
import { bunchModel, studioWith } from "./context";

const opened = specimenFromPreset("long-conical");
const toyModel = toy as unknown as PageModel;

describe("a preset of another model", () => {
	it("is one undo step with its model, growth and address", async () => {
		const { studio, services } = await studioWith(opened);
		const bunch = {} as Plant;
		studio.grew(bunch, opened);
		studio.choosePreset("plain", toyModel);
		expect(studio.state.model).toBe(toyModel);
		expect(studio.state.specimen).toEqual(fromPreset(toyModel));
		expect(services.grow).toHaveBeenLastCalledWith(toyModel, studio.state.specimen, { preview: false });
		expect(services.settled).toHaveBeenLastCalledWith(toyModel, studio.state.specimen);
		expect(studio.preset).toEqual(fromPreset(toyModel));
		studio.undo();
		expect(studio.state.model).toBe(bunchModel);
		expect(studio.state.specimen).toEqual(opened);
		expect(services.grow).toHaveBeenLastCalledWith(bunchModel, opened, { preview: false });
		studio.redo();
		expect(studio.state.model).toBe(toyModel);
	});

	it("leaves the last plant in view, hidden from the new tools", async () => {
		const { studio } = await studioWith(opened);
		const bunch = {} as Plant;
		studio.grew(bunch, opened);
		studio.choosePreset("plain", toyModel);
		expect(studio.state.shown).toMatchObject({ model: bunchModel, grown: bunch });
		expect([studio.state.grown, studio.state.grownFrom]).toEqual([undefined, undefined]);
		const pole = {} as Plant;
		studio.grew(pole, studio.state.specimen);
		expect(studio.state).toMatchObject({ shown: { model: toyModel }, grownFrom: { model: "toy" } });
		expect(studio.state.grown).toBe(pole);
	});

	it("starts its tools, and ends those of the last model", async () => {
		const end = vi.fn();
		const start = vi.fn(() => end);
		const press = vi.fn();
		const tool = { name: "hoist", initial: 0, start, press };
		const { studio } = await studioWith(opened);
		const bunchUi = studio.state.modelUi;
		const model: PageModel = { ...toyModel, ui: async () => ({ tools: [tool] }) };
		studio.choosePreset("plain", model);
		expect(studio.state.modelUi).toBeUndefined();
		await vi.waitFor(() => expect(studio.state.modelUi?.tools).toEqual([tool]));
		expect(start).toHaveBeenCalledExactlyOnceWith(studio);
		studio.setToolState(tool, 3);
		studio.undo();
		expect(end).toHaveBeenCalledOnce();
		await vi.waitFor(() => expect(studio.state.modelUi).toBe(bunchUi));
		expect(studio.toolState(tool)).toBe(3);
		studio.redo();
		await vi.waitFor(() => expect(start).toHaveBeenCalledTimes(2));
		expect(studio.toolState(tool)).toBe(3);
	});

	it("works without tools that cannot be fetched, with a notice", async () => {
		const { studio } = await studioWith(opened);
		const broken: PageModel = { ...toyModel, ui: () => Promise.reject(new Error("offline")) };
		studio.choosePreset("plain", broken);
		await vi.waitFor(() => expect(studio.state.modelUi).toEqual({ tools: [] }));
		expect(studio.state.notices.map(({ title }) => title)).toEqual(["This plant’s tools could not be loaded"]);
	});

	it("loads tools on request after a failed fetch", async () => {
		const { studio } = await studioWith(opened);
		const tools = [{ name: "hoist", initial: 0 }];
		const modelUi = vi.fn(async () => ({ tools })).mockRejectedValueOnce(new Error("offline"));
		studio.choosePreset("plain", { ...toyModel, ui: modelUi });
		await vi.waitFor(() => expect(studio.state.notices).toHaveLength(1));
		studio.state.notices[0].again?.();
		await vi.waitFor(() => expect(studio.state.modelUi).toEqual({ tools }));
	});
});

describe("the state of tools", () => {
	const flag = { name: "flag", initial: { up: false }, recall: (stored: unknown) => ({ up: stored === "up" }) };

	it("is restored and stored for tools with `recall`", async () => {
		const model: PageModel = { ...toyModel, ui: async () => ({ tools: [flag] }) };
		const ui = { ...FIRST_VISIT, tools: { toy: { flag: "up" } } };
		const { studio, services } = await studioWith(fromPreset(toyModel), model, ui);
		expect(studio.toolState(flag)).toEqual({ up: true });
		studio.setToolState(flag, { up: false });
		expect(studio.toolState(flag)).toEqual({ up: false });
		expect(services.remember.mock.lastCall?.[0].tools).toEqual({ toy: { flag: { up: false } } });
	});

	it("is not stored for tools without `recall`", async () => {
		const { studio, services } = await studioWith(opened);
		const tool = { name: "mode", initial: "off" };
		studio.setToolState(tool, "on");
		expect(studio.toolState(tool)).toBe("on");
		expect(services.remember).not.toHaveBeenCalled();
	});
});
