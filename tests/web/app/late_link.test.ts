import { describe, expect, it, vi } from "vitest";
import { openLate } from "../../../web/src/app/late_link";
import type { Restored } from "../../../web/src/specimen/restore";
import { specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

const linked: Restored = { specimen: { ...specimenFromPreset("duku"), seed: 77 }, notes: [] };

async function opening() {
	const { studio } = await studioWith(specimenFromPreset());
	let come!: (restored: Restored) => void;
	let fail!: (error: Error) => void;
	const whole = new Promise<Restored>((resolve, reject) => {
		come = resolve;
		fail = reject;
	});
	return { studio, come, fail, opened: openLate(studio, whole) };
}

describe("a link that is unpacked late", () => {
	it("opens if nothing was changed meanwhile, without an undo step", async () => {
		const { studio, come, opened } = await opening();
		studio.setUi({ theme: "dark" });
		come(linked);
		await opened;
		expect(studio.state.specimen).toBe(linked.specimen);
		expect(studio.state.history.past).toEqual([]);
	});

	it.each([
		["a preset was chosen", (studio: Awaited<ReturnType<typeof opening>>["studio"]) => studio.choosePreset("lychee")],
		["a control is in hand", (studio) => studio.edit({ parameters: { l: 300 } })],
		[
			"a change was undone",
			(studio) => {
				studio.newVariation();
				studio.undo();
			},
		],
	])("leaves the document unchanged where %s, and opens on request as one undo step", async (_, act) => {
		const { studio, come, opened } = await opening();
		act(studio);
		const { specimen, history } = studio.state;
		come(linked);
		await opened;
		expect([studio.state.specimen, studio.state.history]).toEqual([specimen, history]);
		const [notice] = studio.state.notices;
		expect(notice.title).toBe("The link has not been opened yet");
		notice.act?.run();
		expect(studio.state.specimen).toBe(linked.specimen);
		studio.undo();
		expect(studio.state.specimen).toBe(specimen);
	});

	it("shows a notice if the script that unpacks it cannot be fetched", async () => {
		const { studio, fail, opened } = await opening();
		fail(new TypeError("Failed to fetch"));
		await opened;
		expect(studio.state.notices[0].title).toBe("The link could not be read completely");
	});

	it("rejects with an error of opening, without reporting a failed fetch", async () => {
		const { studio, come, opened } = await opening();
		const fault = new Error("a fault of the page");
		vi.spyOn(studio, "open").mockImplementation(() => {
			throw fault;
		});
		come(linked);
		await expect(opened).rejects.toBe(fault);
		expect(studio.state.notices).toEqual([]);
	});
});
