/** Notes on bunches with a custom text. */

import { expect, it } from "vitest";
import { model } from "../../../../web/src/models/bunch";
import { GRAPE_BUNCH_3, GRAPE_BUNCH_4 } from "../../../../web/src/models/bunch/grammars.generated";
import { type Specimen, specimenFromPreset, withParameters } from "../../bunch";
import { freshCore } from "../../core/wasm";

const STALK =
	"The stalk above the bunch does not come from the grammar. The parameter Peduncle sets the length of this stalk; 0 removes it.";

it("explain that the panel controls its stalk, if it has one", async () => {
	const core = await freshCore();
	const notesOf = (specimen: Specimen) =>
		model.read(core.grow(model.encode(specimen, { meshes: false })), specimen).notes;
	const preset = withParameters(specimenFromPreset("short-conical"), { peduncle: 40 });
	const own = { ...preset, grammar: GRAPE_BUNCH_4 };
	expect(notesOf(preset)).toEqual([]);
	expect(notesOf(own)).toEqual([STALK]);
	expect(notesOf(withParameters(own, { peduncle: 0 }))).toEqual([]);
	expect(notesOf({ ...withParameters(own, { procedure: 0 }), grammar: GRAPE_BUNCH_3 })).not.toContain(STALK);
});
