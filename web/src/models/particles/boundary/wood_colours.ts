/** Thin branches have another bark than thick ones: smoother, younger. */
import { type Colour, smoothstep } from "../../../plant/colour";
import type { PlantMesh } from "../../../plant/plant";
import type { WoodenPlant } from "./wooden_plant";

export interface Bark {
	readonly old: Colour;
	readonly young: Colour;
	/** Radii in metres between which the one becomes the other. */
	readonly from: number;
	readonly to: number;
}

/** Of so many radii colours are worked out; those between take the next below. */
const CLASSES = 64;

/** 3 × vertices of the tubes, by the radius of what they go around. */
export function woodColours({ segments, bearing }: WoodenPlant, mesh: PlantMesh, bark: Bark): Float32Array | undefined {
	if (!bearing || bearing.length !== mesh.positions.length / 3) return undefined;
	const palette = Float32Array.from({ length: 3 * CLASSES }, (_, i) => {
		const share = smoothstep(0, 1, Math.floor(i / 3) / (CLASSES - 1));
		return bark.young[i % 3] + share * (bark.old[i % 3] - bark.young[i % 3]);
	});
	const colours = new Float32Array(mesh.positions.length);
	const range = (CLASSES - 1) / (bark.to - bark.from);
	for (let vertex = 0; vertex < bearing.length; vertex++) {
		const radius = segments.radii[2 * bearing[vertex] + 1];
		const place = 3 * Math.max(0, Math.min(CLASSES - 1, Math.floor((radius - bark.from) * range)));
		colours[3 * vertex] = palette[place];
		colours[3 * vertex + 1] = palette[place + 1];
		colours[3 * vertex + 2] = palette[place + 2];
	}
	return colours;
}
