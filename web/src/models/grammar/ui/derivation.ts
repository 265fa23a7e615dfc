import type { DerivationSource } from "../../../grammar_editor/derivation_tool";
import { drawnOf } from "../../../plant/drawn";
import { areaTool } from "../areas/area_tool";
import type { GrammarPlant } from "../grammar_plant";
import type { GrammarSpecimen } from "../specimen";

/** What the stepper has to know of texts' plants: lines, and what is borne; of blades each is a run of their mesh. */
export const derivation: DerivationSource<GrammarSpecimen, GrammarPlant> = {
	drawn: (grown) => drawnOf(grown, { blades: grown.bladeOrgans ?? bladesInTurn(grown) }),
	renderer: async () => new (await import("../../../render/lit_renderer")).LitRenderer(),
	taken: (context) => context.toolState(areaTool).drawing !== undefined,
};

/** Where each polygon shows they follow each other as their runs do. */
function bladesInTurn({ organs, meshes }: GrammarPlant): Uint32Array {
	const polygon = organs.tags.indexOf("polygon");
	const found = Array.from(organs.tag.keys()).filter((organ) => organs.tag[organ] === polygon);
	const runs = meshes.find(({ name }) => name === "blades")?.runs.length;
	return Uint32Array.from(found.length === runs ? found : []);
}
