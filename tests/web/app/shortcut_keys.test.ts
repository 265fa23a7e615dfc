import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { listenForShortcuts } from "../../../web/src/app/shortcuts";
import type { Studio } from "../../../web/src/app/studio";
import { specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

describe("the keyboard shortcuts", () => {
	let studio: Studio;
	let page: EventTarget;
	let dialog: object | null;
	const opens = { help: vi.fn(), saved: vi.fn() };
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
		end = listenForShortcuts(studio, opens);
	});
	afterEach(() => {
		end();
		vi.unstubAllGlobals();
	});

	/** Presses a key. @returns whether the page has handled it */
	const press = (key: string, held: { ctrlKey?: boolean; shiftKey?: boolean } = {}) => {
		const event = Object.assign(new Event("keydown", { cancelable: true }), { key, ...held });
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
		expect(opens.saved).toHaveBeenCalledOnce();
	});

	it("do nothing while a dialog is open, with or without Ctrl", () => {
		studio.newVariation();
		const { specimen } = studio.state;
		dialog = {};
		for (const key of ["z", "y", "s"]) expect(press(key, { ctrlKey: true })).toBe(false);
		expect(press("z", { ctrlKey: true, shiftKey: true })).toBe(false);
		expect(press("n")).toBe(false);
		expect(studio.state.specimen).toBe(specimen);
		expect(opens.saved).not.toHaveBeenCalled();
	});
});
