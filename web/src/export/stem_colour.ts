/** The colours of natural stems, vertex by vertex: green first, woody with age from the peduncle outwards. */
import { type Grown, INTERNODE_KINDS, INTERNODE_STATES, type InternodeKind, type StemMesh } from "../core/grown";
import type { Specimen } from "../specimen/specimen";
import { clamp, colourOf, labOf, linear, mix, smoothstep } from "./colour";
import { noise } from "./noise";

/** How far each kind has turned to wood in a ripe bunch. */
const WOODY: Record<InternodeKind, number> = { rachis: 0.6, axis: 0.4, end: 0.25, pedicel: 0.12 };
const WOOD = labOf(linear("7a5638"));
/** What the pedicels of flowers that fell have dried to. */
const DRY = 0.75;
/** Mottling: noise cells to a metre. */
const MOTTLES = 350;

/** Age in percent at which stems begin to turn, and that at which a shrivelled bunch's are all wood. */
const TURN_FROM = 45;
const TURN_TO = 125;

/** 3 × vertices, linear light. */
export function stemColours({ internodes }: Grown, stem: StemMesh, { look, parameters }: Specimen): Float32Array {
	const ripening = smoothstep(TURN_FROM, 100, parameters.age);
	const drying = smoothstep(100, TURN_TO, parameters.age);
	const woody = Float32Array.from({ length: internodes.count }, (_, i) => {
		const share = WOODY[INTERNODE_KINDS[internodes.kind[i]]] * ripening;
		const withered = INTERNODE_STATES[internodes.state[i]] === "withered" ? DRY : 0;
		return mix(Math.max(share, withered), 1, 0.8 * drying);
	});
	const green = labOf(linear(look.stem));
	const colours = new Float32Array(stem.positions.length);
	const { positions } = stem;
	for (let vertex = 0, at = 0; vertex < stem.internode.length; vertex++, at += 3) {
		const mottle = noise(MOTTLES * positions[at], MOTTLES * positions[at + 1], MOTTLES * positions[at + 2], 0) - 0.5;
		const share = clamp(woody[stem.internode[vertex]] * (1 + 0.7 * mottle));
		const colour = colourOf([
			mix(green[0], WOOD[0], share) * (1 + 0.12 * mottle),
			mix(green[1], WOOD[1], share),
			mix(green[2], WOOD[2], share),
		]);
		colours[at] = colour[0];
		colours[at + 1] = colour[1];
		colours[at + 2] = colour[2];
	}
	return colours;
}
