/** Colours of stems, vertex by vertex, as in the view. */
import { clamp, linear, mix, smoothstep } from "../../../plant/colour";
import { noise } from "../../../plant/noise";
import { type BunchPlant, INTERNODE_STATES, type StemMesh } from "../bunch_plant";
import { BARK, BROWN, LATER, MOTTLES, SHADE, woodOf, YOUNG } from "./stem_rules";

/**
 * Returns the colours of the stems' vertices: 3 × vertices, linear light.
 * @param hex the look's colour of green stems, six hexadecimal digits
 */
export function stemColours(grown: BunchPlant, { positions, uvs, internode }: StemMesh, hex: string): Float32Array {
	const wood = woodOf(grown);
	const green = linear(hex);
	const { kind, state } = grown.internodes;
	const slender = slendernessOf(grown);
	const withered = INTERNODE_STATES.indexOf("withered");
	const colours = new Float32Array(positions.length);
	for (let vertex = 0, at = 0; vertex < internode.length; vertex++, at += 3) {
		const owner = internode[vertex];
		const mottle = noise(
			MOTTLES[0] * uvs[2 * vertex],
			MOTTLES[1] * uvs[2 * vertex + 1],
			MOTTLES[2] * positions[at + 1],
		);
		const aged = wood * (1 - LATER * kind[owner]);
		const dry = state[owner] === withered ? 1 : 0;
		const brown = brownAt(nodeShare(grown, owner, positions, at), slender[owner], mottle, wood, aged, dry);
		const shade = SHADE.least + SHADE.span * mottle;
		for (let k = 0; k < 3; k++) {
			const bark = mix(BARK.first[k], BARK.last[k], aged) * mix(BARK.light, BARK.dry, dry);
			const young = mix(YOUNG.colour[k], 1, Math.min(1, YOUNG.until * wood));
			colours[at + k] = clamp(green[k] * mix(young, bark, brown) * shade);
		}
	}
	return colours;
}

/**
 * Returns how brown a point of a stem is, 0 green … 1 bark: at nodes, in streaks, on woody and on withered stems.
 * @param near nearness to a node, 0 … 1
 * @param slender whether the internode is long enough for distinct nodes, 0 … 1
 * @param mottle noise at the point, 0 … 1
 * @param wood how far the bunch's stems have turned woody, 0 … 1; `aged` is that of the internode
 * @param dry 1 on withered stems, else 0
 */
function brownAt(near: number, slender: number, mottle: number, wood: number, aged: number, dry: number): number {
	const { node, streak, withered, wood: spread } = BROWN;
	const nodes = slender * node.share * smoothstep(node.from, 1, near) * mix(node.young, 1, wood);
	const streaks = streak.share * smoothstep(streak.from, streak.to, mottle) * mix(streak.young, 1, wood);
	const woody = spread.share * smoothstep(spread.from, spread.to, aged + spread.mottle * mottle);
	return clamp(nodes + streaks + withered * dry + woody);
}

/** Returns for each internode whether it is long enough for distinct nodes, 0 … 1. */
function slendernessOf({ internodes: { count, ends, radii } }: BunchPlant): Float32Array {
	const [stout, slender] = BROWN.node.slender;
	return Float32Array.from({ length: count }, (_, i) => {
		const length = Math.hypot(...[0, 1, 2].map((k) => ends[6 * i + 3 + k] - ends[6 * i + k]));
		return smoothstep(stout, slender, length / Math.max(radii[2 * i] + radii[2 * i + 1], 1e-9));
	});
}

/**
 * Returns how near a vertex is to its internode's ends: 0 in the middle, 1 at a node.
 * @param at index of the vertex's x in `positions`
 */
function nodeShare(
	{ internodes: { ends } }: BunchPlant,
	internode: number,
	positions: Float32Array,
	at: number,
): number {
	// Scalar product of the vertex's distance from the middle and the half internode, and the latter's square.
	let dot = 0;
	let square = 0;
	for (let k = 0; k < 3; k++) {
		const half = 0.5 * (ends[6 * internode + 3 + k] - ends[6 * internode + k]);
		dot += (positions[at + k] - ends[6 * internode + k] - half) * half;
		square += half * half;
	}
	return Math.abs(dot) / Math.max(square, 1e-12);
}
