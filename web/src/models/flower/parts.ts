/** A flower in parts: a mesh for each of its materials, coloured from where an organ begins to where it ends. */
import { type Colour, linear, mixed } from "../../plant/colour";
import { type Material, standardMaterial } from "../../plant/material";
import type { Part, PartMesh } from "../../plant/part";
import type { FlowerPlant } from "./flower_plant";

/** What of a kind differs from what is usual for it (plant/material.ts). */
const OWN: Readonly<Record<string, Partial<Material>>> = {
	stem: { roughness: 0.75 },
	leaf: { roughness: 0.55 },
	petal: { sheen: { colour: [0.12, 0.1, 0.11], roughness: 0.5 } },
};

/** How much of an organ's length its foot's colour reaches up. */
const FOOT = 0.6;

const KINDS: Readonly<Record<string, string>> = { leaf: "blade" };

export function* flowerParts(plant: FlowerPlant): Generator<Part> {
	const names = new Map<string, number>();
	for (const [i, mesh] of plant.meshes.entries()) {
		const [base, tip] = [...plant.colours.subarray(4 * i, 4 * i + 2)].map(colourOf);
		const named = mesh.material.charAt(0).toUpperCase() + mesh.material.slice(1);
		const before = names.get(named) ?? 0;
		names.set(named, before + 1);
		const name = before === 0 ? named : `${named} ${before + 1}`;
		const usual = standardMaterial(KINDS[mesh.material] ?? mesh.material);
		const material: Material = {
			...usual,
			...OWN[mesh.material],
			name,
			colour: mixed(base, tip, 0.5),
			// The skin is closed: there is no other side to see.
			doubleSided: false,
		};
		yield { name, shape: { mesh: coloured(mesh, base, tip), material } };
	}
}

const colourOf = (packed: number): Colour => linear(packed.toString(16).padStart(6, "0"));

/** Along organs: from the colour of their foot to that of their tip, which most of them has. */
function coloured(mesh: PartMesh, base: Colour, tip: Colour): PartMesh {
	const colours = new Float32Array(mesh.positions.length);
	for (let v = 0; v < colours.length / 3; v++) {
		const along = Math.min(1, mesh.uvs[2 * v] / FOOT);
		const part = along * along * (3 - 2 * along);
		for (let c = 0; c < 3; c++) colours[3 * v + c] = base[c] + (tip[c] - base[c]) * part;
	}
	return { ...mesh, colours };
}
