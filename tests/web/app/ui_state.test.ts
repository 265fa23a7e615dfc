import { describe, expect, it } from "vitest";
import { FIRST_VISIT, loadUi, pageOf, saveUi, type UiState } from "../../../web/src/app/ui_state";

function storage(stored?: string) {
	let text = stored ?? null;
	return {
		getItem: () => text,
		setItem: (_key: string, value: string) => {
			text = value;
		},
	};
}

describe("what the page remembers", () => {
	it("is restored as it was stored", () => {
		const ui: UiState = {
			...FIRST_VISIT,
			theme: "dark",
			letters: false,
			toolNames: true,
			symbols: true,
			scaleBar: false,
			groups: { rates: true, look: false },
			tools: { bunch: { sides: { leftRight: true } } },
		};
		const stored = storage();
		saveUi(stored, ui, FIRST_VISIT);
		expect(loadUi(stored)).toEqual(ui);
	});

	it("does not restore the view of a phone", () => {
		const stored = storage();
		saveUi(stored, { ...FIRST_VISIT, view: "side" }, FIRST_VISIT);
		expect(loadUi(stored)).toEqual(FIRST_VISIT);
	});

	it.each(["", "nonsense", "null", "[]", "7", '{"theme":"pink","groups":[1],"tools":3}', '{"groups":{"look":"shut"}}'])(
		"is the first visit's where %j was kept",
		(text) => {
			expect(loadUi(storage(text))).toEqual(FIRST_VISIT);
		},
	);

	it("stores only the changes of its own tab", () => {
		const stored = storage();
		const change = (patch: Partial<UiState>) => saveUi(stored, { ...FIRST_VISIT, ...patch }, FIRST_VISIT);
		change({ theme: "dark" });
		change({ groups: { look: true } });
		change({ groups: { rates: true } });
		change({ letters: false });
		change({ tools: { bunch: { sides: 1 } } });
		change({ tools: { bunch: { other: 2 }, leaf: { vein: 3 } } });
		expect(loadUi(stored)).toEqual({
			...FIRST_VISIT,
			theme: "dark",
			letters: false,
			groups: { look: true, rates: true },
			tools: { bunch: { sides: 1, other: 2 }, leaf: { vein: 3 } },
		});
	});

	it("shares only theme, language, keyboard setting, names of tools, symbols, outdoors, scale bar, favourites and recent presets with other tabs", () => {
		const ui: UiState = { ...FIRST_VISIT, theme: "dark", scaleBar: true, groups: { look: true } };
		expect(pageOf(ui)).toEqual({
			theme: "dark",
			language: "",
			outdoors: true,
			letters: true,
			toolNames: false,
			symbols: false,
			scaleBar: true,
			favourites: [],
			recentPresets: [],
		});
	});

	it("reads at most 200 favourites and 12 recent presets, each once, and nothing that is not a preset's key", () => {
		const many = Array.from({ length: 300 }, (_, i) => `growth/tree-${i}`);
		const stored = { favourites: [...many, ...many], recentPresets: ["growth/oak", "growth/oak", 3, "<b>", ...many] };
		const { favourites, recentPresets } = loadUi({ getItem: () => JSON.stringify(stored) });
		expect(favourites).toEqual(many.slice(0, 200));
		expect(recentPresets).toEqual(["growth/oak", ...many.slice(0, 11)]);
	});

	it("works without storage", () => {
		const forbidden = {
			getItem: () => {
				throw new Error("denied");
			},
			setItem: () => {
				throw new Error("denied");
			},
		};
		expect(loadUi(forbidden)).toEqual(FIRST_VISIT);
		expect(() => saveUi(forbidden, FIRST_VISIT, FIRST_VISIT)).not.toThrow();
	});
});
