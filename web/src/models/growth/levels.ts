/** Levels of detail of a tree: bark, leaves and blossoms, each in one colour. */
import { linear, mixed } from "../../plant/colour";
import { leafColour } from "../../plant/leaf_colours";
import type { Material } from "../../plant/material";
import { cut, type Part } from "../../plant/part";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import { leafSeason } from "./year";

const LEVEL = /^level\d$/;
/** Share of young wood in the visible wood. */
const YOUNG = 0.4;

/** Returns the parts of each level, in the order of the plant's meshes. */
export function growthLevels({ meshes }: GrowthPlant, specimen: GrowthSpecimen): Part[][] {
	const materials = materialsOf(specimen);
	return meshes
		.filter(({ name }) => LEVEL.test(name))
		.map((mesh) =>
			mesh.runs.map((run) => ({
				name: run.name,
				shape: { mesh: cut(mesh, run), material: materials[run.name] ?? materials.leaves },
			})),
		);
}

/** Returns the materials by the names of the levels' runs. */
function materialsOf(specimen: GrowthSpecimen): Record<string, Material> {
	const { look, parameters } = specimen;
	const season = leafSeason(parameters.season, GROWTH_TABLE.option(specimen, "year") === "evergreen");
	const leaf = leafColour({ leaf: look.leaf, autumn: look.autumn, season });
	return {
		bark: { name: "Bark", colour: mixed(linear(look.bark), linear(look.young_bark), YOUNG), roughness: 0.9 },
		leaves: {
			name: "Leaf",
			colour: leaf,
			roughness: 0.6,
			doubleSided: true,
			sheet: { through: [0.75, 0.85, 0.45], reverse: [1.3, 1.2, 1.4] },
		},
		blossoms: {
			name: "Petal",
			colour: linear(look.petal),
			roughness: 0.65,
			doubleSided: true,
			sheet: { through: [0.9, 0.85, 0.85], reverse: [1, 0.98, 0.98] },
		},
	};
}
