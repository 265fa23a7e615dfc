import { expect, it } from "vitest";
import { model } from "../../../web/src/models/grammar/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { freshCore } from "./wasm";

it("notes of any length are whole in the page: nothing is read where the core has let go of it", async () => {
	const core = await freshCore("grammar.wasm");
	const lines = Array.from({ length: 900 }, (_, i) => `X${i} --> F [ F${i} ]`);
	const specimen = { ...fromPreset(model), constants: {}, grammar: ["axiom: A", ...lines].join("\n") };
	const { notes } = model.read(core.grow(model.encode(specimen)));
	expect(notes.join("\n").length).toBeGreaterThan(1 << 14);
	expect(notes[0]).toBe("The grammar draws nothing.");
	expect(notes).toHaveLength(901);
});
