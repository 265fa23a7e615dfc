import { expect, it } from "vitest";
import { coreText, loadCoreMessages } from "../../../web/src/core/core_message";
import { model } from "../../../web/src/models/grammar/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { freshCore } from "./wasm";

it("notes of any length are whole in the page: nothing is read where the core has let go of it", async () => {
	const core = await freshCore("grammar.wasm");
	const lines = Array.from({ length: 900 }, (_, i) => `X${i} --> F [ F${i} ]`);
	const specimen = { ...fromPreset(model), constants: {}, grammar: ["axiom: A", ...lines].join("\n") };
	const { notes } = model.read(core.grow(model.encode(specimen)));
	expect(notes.join("\n").length).toBeGreaterThan(1 << 14);
	await loadCoreMessages();
	expect(coreText(notes[0])).toBe(
		"The grammar does not draw anything; add a symbol that draws, such as “F” for a line.",
	);
	expect(notes).toHaveLength(901);
});
