import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { HELP, PALETTE, SAVED, SHORTCUTS } from "../../../web/src/app/parts/late_parts";
import { openPart } from "../../../web/src/app/parts/open_part";
import { listenForShortcuts } from "../../../web/src/app/shortcuts";
import type { Studio } from "../../../web/src/app/studio";
import { specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

interface Held {
	ctrlKey?: boolean;
	metaKey?: boolean;
	shiftKey?: boolean;
	altKey?: boolean;
}
const NONE: Held = { ctrlKey: false, metaKey: false, shiftKey: false };

vi.mock("../../../web/src/app/parts/open_part", () => ({ openPart: vi.fn() }));

describe("the keyboard shortcuts", () => {
	let studio: Studio;
	let page: EventTarget;
	let dialog: object | null;
	let end: () => void;

	beforeEach(async () => {
		vi.clearAllMocks();
		page = new EventTarget();
		dialog = null;
		vi.stubGlobal("window", page);
		vi.stubGlobal("document", { querySelector: (selector: string) => (selector === "dialog[open]" ? dialog : null) });
		for (const name of ["HTMLTextAreaElement", "HTMLSelectElement", "HTMLElement", "HTMLInputElement"])
			vi.stubGlobal(name, class {});
		({ studio } = await studioWith(specimenFromPreset()));
		end = listenForShortcuts(studio);
	});
	afterEach(() => {
		end();
		vi.unstubAllGlobals();
	});

	/** Presses a key. @returns whether the page has handled it */
	const press = (key: string, held: Held = {}, target: object = {}) => {
		const path = { composedPath: () => [target] };
		const event = Object.assign(new Event("keydown", { cancelable: true }), {
			key,
			altKey: false,
			...NONE,
			...held,
			...path,
		});
		page.dispatchEvent(event);
		return event.defaultPrevented;
	};

	it("undo, redo and open the saved specimens", () => {
		const before = studio.state.specimen;
		studio.newVariation();
		const after = studio.state.specimen;
		expect(press("z", { ctrlKey: true })).toBe(true);
		expect(studio.state.specimen).toBe(before);
		press("y", { ctrlKey: true });
		expect(studio.state.specimen).toBe(after);
		press("s", { ctrlKey: true });
		expect(openPart).toHaveBeenLastCalledWith(studio, SAVED);
	});

	it("do nothing while a dialog is open, with or without Ctrl", () => {
		studio.newVariation();
		const { specimen } = studio.state;
		dialog = {};
		for (const key of ["z", "y", "s"]) expect(press(key, { ctrlKey: true })).toBe(false);
		expect(press("z", { ctrlKey: true, shiftKey: true })).toBe(false);
		expect(press("n")).toBe(false);
		expect(studio.state.specimen).toBe(specimen);
		expect(press("k", { ctrlKey: true })).toBe(false);
		expect(openPart).not.toHaveBeenCalled();
	});

	it("open the palette with Ctrl or ⌘, also from a text field, which keeps all other keys", () => {
		const field = Object.assign(new HTMLInputElement(), { type: "text" });
		expect(press("k", { ctrlKey: true })).toBe(true);
		expect(press("K", { metaKey: true }, field)).toBe(true);
		expect(openPart).toHaveBeenCalledTimes(2);
		expect(openPart).toHaveBeenLastCalledWith(studio, PALETTE);
		for (const [key, held] of [
			["z", { ctrlKey: true }],
			["n", {}],
			["?", {}],
			["k", {}],
		] as const)
			expect(press(key, held, field)).toBe(false);
		expect(press("k", { ctrlKey: true, altKey: true })).toBe(false);
		expect(press("k", { ctrlKey: true, shiftKey: true })).toBe(false);
	});

	it("are single letters only while these are switched on, and signs also with Shift", () => {
		expect(press("?", { shiftKey: true })).toBe(true);
		expect(openPart).toHaveBeenLastCalledWith(studio, SHORTCUTS);
		const { seed } = studio.state.specimen;
		expect(press("N", { shiftKey: true })).toBe(false);
		studio.setUi({ letters: false });
		expect(press("n")).toBe(false);
		expect(studio.state.specimen.seed).toBe(seed);
		studio.setUi({ letters: true });
		expect(press("n")).toBe(true);
		expect(studio.state.specimen.seed).not.toBe(seed);
	});

	it("open the help with F1, also from a text field and without single letters", () => {
		const field = Object.assign(new HTMLInputElement(), { type: "text" });
		studio.setUi({ letters: false });
		expect(press("F1")).toBe(true);
		expect(press("F1", {}, field)).toBe(true);
		expect(openPart).toHaveBeenCalledTimes(2);
		expect(openPart).toHaveBeenLastCalledWith(studio, HELP);
		expect(press("F1", { ctrlKey: true })).toBe(false);
		expect(press("?", { shiftKey: true })).toBe(false);
		studio.setUi({ letters: true });
	});

	it("are handled, without effect, where their action cannot be run", () => {
		const { specimen } = studio.state;
		expect(press("z", { ctrlKey: true })).toBe(true);
		expect(studio.state.specimen).toBe(specimen);
	});
});
