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
			closed: ["rates"],
			locks: { leftRight: true, frontBack: false },
		};
		const kept = storage();
		saveUi(kept, ui);
		expect(loadUi(kept)).toEqual(ui);
	});

	it("starts afresh with what shows a picture first: a view, not a mode", () => {
		const kept = storage();
		saveUi(kept, { ...FIRST_VISIT, view: "side", stems: true, octahedron: true });
		expect(loadUi(kept)).toEqual(FIRST_VISIT);
	});

	it.each(["", "nonsense", "null", "[]", "7", '{"theme":"pink","closed":{},"locks":3}', '{"closed":[1,2]}'])(
		"is the first visit's where %j was kept",
		(text) => {
			const ui = loadUi(storage(text));
			expect(ui).toEqual({ ...FIRST_VISIT, closed: text.includes("[1") ? [] : FIRST_VISIT.closed });
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
