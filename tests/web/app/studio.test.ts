import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Studio } from "../../../web/src/app/studio";
import type { PageModel } from "../../../web/src/models/page_model";
import type { Plant } from "../../../web/src/plant/plant";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { specimenFromPreset } from "../bunch";
import { toy } from "../toy";
import { bunchModel, studioWith } from "./context";

const opened = specimenFromPreset("long-conical");
const toyModel = toy as unknown as PageModel;

describe("the studio", () => {
	let studio: Studio;
	let services: Awaited<ReturnType<typeof studioWith>>["services"];

	const grownLast = () => services.grow.mock.lastCall?.[1];
	const length = () => studio.state.specimen.parameters.l;

	beforeEach(async () => {
		({ studio, services } = await studioWith(opened));
	});

	it("grows at every step of a drag, and makes one undo step and one address at its end", () => {
		for (const l of [400, 390, 380]) studio.edit({ parameters: { l } });
		expect(services.grow).toHaveBeenCalledTimes(3);
		expect(services.grow).toHaveBeenLastCalledWith(bunchModel, studio.state.specimen, { preview: true });
		expect(services.settled).not.toHaveBeenCalled();
		studio.settle();
		expect(services.settled).toHaveBeenCalledExactlyOnceWith(bunchModel, studio.state.specimen);
		studio.undo();
		expect(studio.state.specimen).toEqual(opened);
		expect(grownLast()).toEqual(opened);
		studio.redo();
		expect(length()).toBe(380);
	});

	it("requests measures once after a drag, and with every single step", () => {
		studio.edit({ parameters: { l: 400 } });
		studio.settle();
		expect(services.grow).toHaveBeenCalledTimes(2);
		expect(services.grow).toHaveBeenLastCalledWith(bunchModel, studio.state.specimen, { preview: false });
		studio.settle();
		expect(services.grow).toHaveBeenCalledTimes(2);
		studio.edit({ parameters: { l: 300 } });
		studio.edit({ parameters: { l: 400 } });
		studio.settle();
		expect(services.grow.mock.lastCall?.[2]).toEqual({ preview: false });
		services.grow.mockClear();
		studio.set({ parameters: { l: 390 } });
		expect(services.grow).toHaveBeenCalledExactlyOnceWith(bunchModel, studio.state.specimen, { preview: false });
	});

	it("retains the last measures during a drag, but not those of another model", () => {
		const measures = Float32Array.of(1, 2);
		studio.grew({ measures } as Plant, opened);
		studio.grew({} as Plant, opened);
		expect(studio.state.measures).toBe(measures);
		studio.choosePreset("plain", toyModel);
		expect(studio.state.measures).toBeUndefined();
		studio.grew({} as Plant, studio.state.specimen);
		studio.undo();
		expect(studio.state.measures).toBeUndefined();
	});

	it("makes a step of every drag", () => {
		studio.set({ parameters: { l: 400 } });
		studio.set({ parameters: { l: 300 } });
		studio.undo();
		expect(length()).toBe(400);
		expect(services.settled.mock.lastCall?.[1].parameters.l).toBe(400);
	});

	it("adds no undo step when a drag ends where it began", () => {
		studio.edit({ parameters: { l: 400 } });
		studio.edit({ parameters: { l: opened.parameters.l } });
		studio.settle();
		expect(studio.state.history.past).toHaveLength(0);
	});

	it("does not grow for a change of colour, but draws it and updates the address", () => {
		const listener = vi.fn();
		studio.subscribe(listener);
		studio.set({ look: { skin: "ffffff" } });
		expect(services.grow).not.toHaveBeenCalled();
		expect(listener).toHaveBeenCalled();
		expect(services.settled).toHaveBeenCalled();
	});

	it("removes the notice about a link with the first change, and no other notice", () => {
		studio.open(
			{
				specimen: specimenFromPreset("lychee"),
				notes: [{ key: "l", problem: "", text: "l: too long.", code: "", args: {} }],
			},
			"link",
		);
		studio.notify("Mind the gap");
		const titles = () => studio.state.notices.map(({ title }) => title);
		studio.settle();
		expect(titles()).toEqual(["Some of this link could not be read", "Mind the gap"]);
		studio.edit({ parameters: { l: 300 } });
		expect(titles()).toEqual(["Mind the gap"]);
	});

	it("shows one notice about the parts of a link that could not be used, until it is dismissed", () => {
		const notes = [{ key: "l", problem: "", text: "l: too long.", code: "", args: {} }];
		studio.take(bunchModel, { specimen: specimenFromPreset("lychee"), notes }, "link");
		studio.take(bunchModel, { specimen: specimenFromPreset("lychee"), notes }, "link");
		expect(studio.state.notices).toMatchObject([
			{ title: "Some of this link could not be read", details: ["l: too long."] },
		]);
		studio.dismiss(studio.state.notices[0].id);
		expect(studio.state.notices).toHaveLength(0);
	});

	it("follows Back and Forward by undo and redo where the document matches, otherwise adds a step", () => {
		const visit = (specimen: typeof opened) => studio.visit(bunchModel, { specimen, notes: [] }, "link");
		const lychee = specimenFromPreset("lychee");
		studio.choosePreset("lychee");
		visit(opened);
		expect(studio.state.history).toEqual({ past: [], present: opened, future: [lychee] });
		visit(lychee);
		expect(studio.state.history).toEqual({ past: [opened], present: lychee, future: [] });
		visit(specimenFromPreset("duku"));
		expect(studio.state.history.past).toEqual([opened, lychee]);
		studio.undo();
		expect(studio.state.specimen).toEqual(lychee);
	});

	it("is pending while the plant in view is older than the document", () => {
		expect(studio.state.pending).toBe(false);
		studio.set({ parameters: { l: 400 } });
		expect(studio.state.pending).toBe(true);
		studio.caughtUp();
		expect(studio.state.pending).toBe(false);
	});

	it("opens a document as the first of its history, grows it, writes the address and shows its notes", () => {
		const grammar = { ...specimenFromPreset("lychee"), grammar: "axiom: F" };
		studio.open(
			{ specimen: grammar, notes: [{ key: "l", problem: "", text: "l: too long.", code: "", args: {} }] },
			"link",
		);
		expect(studio.state.specimen).toEqual(grammar);
		expect(studio.state.history).toEqual({ past: [], present: grammar, future: [] });
		expect(services.grow).toHaveBeenCalledExactlyOnceWith(bunchModel, grammar, { preview: false });
		expect(services.settled).toHaveBeenCalledExactlyOnceWith(bunchModel, grammar);
		expect(studio.state.notices).toMatchObject([{ details: ["l: too long."] }]);
	});

	it("opens the published preset including its seed, undoes that, and resets", () => {
		studio.newVariation();
		studio.choosePreset("duku");
		expect(studio.state.specimen).toEqual(specimenFromPreset("duku"));
		studio.undo();
		studio.reset();
		expect(studio.state.specimen).toEqual(opened);
	});

	it("remembers which groups are open, and stores each change once", () => {
		studio.setGroup("shape", false);
		studio.setGroup("shape", false);
		expect(services.remember).toHaveBeenCalledOnce();
		expect(services.remember.mock.lastCall?.map(({ groups }) => groups)).toEqual([{ shape: false }, {}]);
		expect(studio.state.ui.groups).toEqual({ shape: false });
		studio.setGroup("shape", true);
		expect(studio.state.ui.groups).toEqual({ shape: true });
	});

	it("follows the system's colour scheme until a theme is chosen", () => {
		expect(studio.state.dark).toBe(false);
		studio.setSystemDark(true);
		expect(studio.state.dark).toBe(true);
		studio.setUi({ theme: "light" });
		expect(studio.state.dark).toBe(false);
		studio.setUi({ theme: "dark" });
		studio.setSystemDark(false);
		expect(studio.state.dark).toBe(true);
	});

	it("removes brief notices after a while, and no others", async () => {
		vi.useFakeTimers();
		studio.notify("Link copied", [], { brief: true });
		studio.notify("Mind the gap");
		await vi.advanceTimersByTimeAsync(5000);
		expect(studio.state.notices.map(({ title }) => title)).toEqual(["Mind the gap"]);
		vi.useRealTimers();
	});

	it("shows the three newest notices, each title once", () => {
		for (const title of ["One", "Two", "Three", "Four", "Three"]) studio.notify(title);
		expect(studio.state.notices.map(({ title }) => title)).toEqual(["Two", "Four", "Three"]);
		studio.dismiss(studio.state.notices[1].id);
		expect(studio.state.notices.map(({ title }) => title)).toEqual(["Two", "Three"]);
	});

	it("replaces a notice by the next of its topic, and removes it when a document of that source is opened", () => {
		const titles = () => studio.state.notices.map(({ title }) => title);
		studio.notify("Mind the gap");
		studio.notify("The file was not opened", [], { topic: "file" });
		studio.notify("The mesh is now the boundary", [], { topic: "file" });
		expect(titles()).toEqual(["Mind the gap", "The mesh is now the boundary"]);
		studio.take(toyModel, { specimen: fromPreset(toyModel), notes: [] }, "file");
		expect(titles()).toEqual(["Mind the gap"]);
	});

	it("clears a failure as soon as a plant grows", () => {
		studio.fail({ title: "No", details: [], remedies: [] });
		studio.grew({} as Plant, opened);
		expect(studio.state.failure).toBeUndefined();
	});

	it("is held during a drag, until its gesture is settled", () => {
		studio.edit({ parameters: { l: 400 } });
		expect(studio.state.held).toBe(true);
		studio.settle("another gesture");
		expect(studio.state.held).toBe(true);
		studio.settle();
		expect(studio.state.held).toBe(false);
	});
});
