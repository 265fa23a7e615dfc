/** A small made-up plant as parts, with all that parts can have: colours, instances, a centre, a variant, children. */

import type { About } from "../../../web/src/formats/about";
import type { Material } from "../../../web/src/plant/material";
import type { Part, PartMesh } from "../../../web/src/plant/part";
import { partsOf } from "../../../web/src/plant/parts_of";
import { toyPlant } from "../plant/toy_plant";

export const ABOUT: About = {
	name: "Toy one",
	link: "?model=toy&seed=3",
	extras: { specimen: { seed: 3 }, measures: { height: 0.18, spread: null } },
};

/** A plant without a model or materials. */
export const plain = (): Part[] => [...partsOf(toyPlant())];

export const PULP: Material = {
	name: "Pulp",
	colour: [0.5, 0.25, 0.1],
	roughness: 0.4,
	sheen: { colour: [0.1, 0.1, 0.12], roughness: 0.5 },
};
export const HAIR: Material = { name: "Hair", colour: [0.9, 0.9, 0.8], roughness: 0.7 };

/** A tetrahedron about `centre`. */
export function tetrahedron(centre: readonly number[], size: number, colours?: number[]): PartMesh {
	const corners = [1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1];
	const unit = 1 / Math.sqrt(3);
	return {
		positions: Float32Array.from(corners, (value, i) => centre[i % 3] + size * value),
		normals: Float32Array.from(corners, (value) => value * unit),
		uvs: UVS,
		indices: TRIANGLES,
		...(colours ? { colours: Float32Array.from(colours) } : {}),
	};
}

const UVS = Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]);
const TRIANGLES = Uint32Array.from([0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2]);

export const CENTRES = [
	[0.01, 0.02, 0.03],
	[-0.01, 0.05, 0.004],
] as const;
const SHADES = [
	[0.8, 0.2, 0.1, 0.4, 0.2, 0.1, 0.4, 0.2, 0.1, 0.4, 0.2, 0.1],
	[0.2, 0.6, 0.1, 0.2, 0.6, 0.1, 0.2, 0.6, 0.1, 0.2, 0.6, 0.1],
];

/** Two fruits of one pattern, each coloured, held by its centre; the second has a tuft of hair, turned and scaled. */
export function fruits(): Part[] {
	const tuft: Part = {
		name: "Tuft",
		shape: {
			mesh: { ...tetrahedron([0, 0, 0], 2), name: "Tuft mesh" },
			material: HAIR,
			instances: { transforms: Float32Array.from([...CENTRES[1], 0, 1, 0, 0, 0.001]) },
		},
	};
	const children = CENTRES.map(
		(centre, i): Part => ({
			name: `Fruit ${i + 1}`,
			shape: {
				mesh: tetrahedron(centre, 0.004, SHADES[i]),
				material: PULP,
				centre,
				variant: i === 0 ? "" : "green",
			},
			extras: { weight: Math.fround(0.1), label: "a", exact: 0.1 },
			...(i === 1 ? { children: [tuft] } : {}),
		}),
	);
	return [{ name: "Fruits", children }];
}
