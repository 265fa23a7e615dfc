import type { DerivationSource } from "../../../grammar_editor/derivation_tool";
import { drawnOf } from "../../../plant/drawn";
import { areaTool } from "../areas/area_tool";
import type { GrammarPlant } from "../grammar_plant";
import type { GrammarSpecimen } from "../specimen";

/** Geometry of a text's plant for the derivation stepper: segments and organs; each blade is a run of its mesh. */
export const derivation: DerivationSource<GrammarSpecimen, GrammarPlant> = {
	drawn: (grown) => drawnOf(grown, { blades: grown.bladeOrgans ?? bladesInOrder(grown) }),
	renderer: async () => new (await import("../../../render/lit_renderer")).LitRenderer(),
	taken: (context) => context.toolState(areaTool).drawing !== undefined,
};

/** Returns the organ of each run if every polygon is visible: both then have the same order. */
function bladesInOrder({ organs, meshes }: GrammarPlant): Uint32Array {
	const polygon = organs.tags.indexOf("polygon");
	const polygons = Array.from(organs.tag.keys()).filter((organ) => organs.tag[organ] === polygon);
	const runs = meshes.find(({ name }) => name === "blades")?.runs.length;
	return Uint32Array.from(polygons.length === runs ? polygons : []);
}
