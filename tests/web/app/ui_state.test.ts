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

	it("shares only theme and keyboard setting with other tabs", () => {
		const ui: UiState = { ...FIRST_VISIT, theme: "dark", groups: { look: true } };
		expect(pageOf(ui)).toEqual({ theme: "dark", letters: true });
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
