import { describe, expect, it } from "vitest";
import { FIRST_VISIT, loadUi, saveUi, type UiState } from "../../../web/src/studio/ui_state";

function storage(kept?: string) {
	let text = kept ?? null;
	return {
		getItem: () => text,
		setItem: (_key: string, value: string) => {
			text = value;
		},
	};
}

describe("what the page remembers", () => {
	it("comes back as it was saved", () => {
		const ui: UiState = {
			...FIRST_VISIT,
			theme: "dark",
			groups: { rates: true, look: false },
			tools: { bunch: { sides: { leftRight: true } } },
		};
		const kept = storage();
		saveUi(kept, ui);
		expect(loadUi(kept)).toEqual(ui);
	});

	it("starts afresh with what shows a picture first: a view, not a mode", () => {
		const kept = storage();
		saveUi(kept, { ...FIRST_VISIT, view: "side" });
		expect(loadUi(kept)).toEqual(FIRST_VISIT);
	});

	it.each(["", "nonsense", "null", "[]", "7", '{"theme":"pink","groups":[1],"tools":3}', '{"groups":{"look":"shut"}}'])(
		"is the first visit's where %j was kept",
		(text) => {
			expect(loadUi(storage(text))).toEqual(FIRST_VISIT);
		},
	);

	it("does without storage", () => {
		const forbidden = {
			getItem: () => {
				throw new Error("denied");
			},
			setItem: () => {
				throw new Error("denied");
			},
		};
		expect(loadUi(forbidden)).toEqual(FIRST_VISIT);
		expect(() => saveUi(forbidden, FIRST_VISIT)).not.toThrow();
	});
});
