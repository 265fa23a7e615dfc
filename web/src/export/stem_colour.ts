/**
 * The colours of natural stems, vertex by vertex: green first, woody as the berries turn and dry, from the nodes, the
 * rachis first and pedicels last. The same rules by which the app draws them (scene/stem_material.ts).
 */
import { type Grown, INTERNODE_KINDS, INTERNODE_STATES, type StemMesh } from "../models/bunch/grown";
import type { Specimen } from "../specimen/specimen";
import { clamp, linear, mix, smoothstep } from "./colour";
import { meanOf } from "./meshes";
import { noise } from "./noise";

/** By how much less wood the last kind of internode has than the first. */
const LATE = 0.3;
/** Mottling: noise cells to a metre. */
const MOTTLES = 350;
/** What young skin and bark, at its first and at its last, make of green. */
const YOUNG = [0.82, 1.12, 0.72];
const BARK = [0.92, 0.62, 0.5];
const OLD_BARK = [0.8, 0.48, 0.36];

/** 3 × vertices, linear light. */
export function stemColours(grown: Grown, stem: StemMesh, { look }: Specimen): Float32Array {
	const wood = 0.55 * meanOf(grown, "turned", 1) + 0.45 * meanOf(grown, "shrivel");
	const green = linear(look.stem);
	const { kind, state } = grown.internodes;
	const withered = INTERNODE_STATES.indexOf("withered");
	const { positions } = stem;
	const colours = new Float32Array(positions.length);
	for (let vertex = 0, at = 0; vertex < stem.internode.length; vertex++, at += 3) {
		const of = stem.internode[vertex];
		const mottle = noise(MOTTLES * positions[at], MOTTLES * positions[at + 1], MOTTLES * positions[at + 2], 0);
		const aged = wood * (1 - (LATE * kind[of]) / (INTERNODE_KINDS.length - 1));
		const dry = state[of] === withered ? 1 : 0;
		const node = 0.45 * smoothstep(0.72, 1, nodeShare(grown, of, positions, at));
		const streaks = 0.5 * smoothstep(0.45, 0.85, mottle) * (0.4 + 0.6 * wood);
		const brown = clamp(
			node * (0.3 + 0.7 * wood) + streaks + 0.75 * dry + 0.9 * smoothstep(0.35, 1.1, aged + 0.3 * mottle),
		);
		for (let k = 0; k < 3; k++) {
			const bark = mix(BARK[k], OLD_BARK[k], aged) * mix(0.85, 0.5, dry);
			const young = mix(YOUNG[k], 1, Math.min(1, 1.6 * wood));
			colours[at + k] = clamp(green[k] * mix(young, bark, brown) * (0.92 + 0.42 * mottle));
		}
	}
	return colours;
}

/** How near a place is to its internode's ends: 0 in the middle, 1 at a node. */
function nodeShare({ internodes: { ends } }: Grown, internode: number, positions: Float32Array, at: number): number {
	let along = 0;
	let length = 0;
	for (let k = 0; k < 3; k++) {
		const start = ends[6 * internode + k];
		const end = ends[6 * internode + 3 + k];
		along += (positions[at + k] - (start + end) / 2) * (end - start);
		length += (end - start) ** 2;
	}
	return length > 0 ? Math.abs((2 * along) / length) : 1;
}
