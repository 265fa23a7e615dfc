/** A tree of a growth grammar for four distances: bark and leaves, in one colour each. */
import { linear, mixed } from "../../plant/colour";
import { leafColour } from "../../plant/leaf_colours";
import type { Material } from "../../plant/material";
import { cut, type Part } from "../../plant/part";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";

const LEVEL = /^level\d$/;
/** What twigs of any tree come near to, and their share of what is seen of wood. */
const TWIG = linear("4d3f33");
const TWIGS = 0.4;

export function growthLevels({ meshes }: GrowthPlant, { look }: GrowthSpecimen): Part[][] {
	const bark: Material = { name: "Bark", colour: mixed(linear(look.bark), TWIG, TWIGS), roughness: 0.92 };
	const leaves: Material = {
		name: "Leaf",
		colour: leafColour(look),
		roughness: 0.6,
		doubleSided: true,
		sheet: { through: [0.75, 0.85, 0.45], reverse: [1.3, 1.2, 1.4] },
	};
	return meshes
		.filter(({ name }) => LEVEL.test(name))
		.map((mesh) =>
			mesh.runs.map((run) => ({
				name: run.name,
				shape: { mesh: cut(mesh, run), material: run.name === "bark" ? bark : leaves },
			})),
		);
}
