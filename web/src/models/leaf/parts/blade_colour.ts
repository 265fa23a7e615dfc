/** The colours of a blade: fresh, in autumn, dry. The textures (face_pictures.ts) are made of these. */
import { type Colour, linear, mixed, smoothstep } from "../../../plant/colour";
import type { LeafSpecimen } from "../specimen";
import type { BladeFields } from "./blade_fields";

/** Share of the veins' colour in the paler blade along veins. */
const HALO = 0.16;
/** Colour of dry tissue. */
const BROWN: Colour = [0.2, 0.085, 0.025];
/** Widths of the rims along the margin that change colour and dry before the rest, in leaf lengths. */
const TURNING_RIM = 0.11;
const DRYING_RIM = 0.12;
/** Time at which tissue far from veins changes colour, and the delay on the widest vein, in shares of autumn. */
const TURN_TIME = 0.4;
const VEIN_DELAY = 0.55;
/** Duration of the change of colour, before and after that time: tissue farther from veins fades earlier. */
const FADE_TIME = 0.26;
/** Duration of drying. */
const DRYING_TIME = 0.3;

/** Colours at one position, linear light. */
export interface BladeColour {
	blade: Colour;
	/** Colour of the veins at the position. */
	vein: Colour;
}

/**
 * Returns a function that computes the colours of cell `at`.
 * @param green colour of the face between veins
 */
export function bladeColours(
	look: LeafSpecimen["look"],
	green: Colour,
): (fields: BladeFields, at: number) => BladeColour {
	const [fresh, late] = [linear(look.vein_colour as string), linear(look.autumn_colour as string)];
	const [autumn, uneven, scorch] = [look.autumn as number, look.uneven as number, look.scorch as number];
	const lateVein = mixed(scaled(late, 0.85), fresh, 0.25);
	// The season starts before the first cell changes and ends after the last.
	const season = -0.45 + 1.95 * autumn;
	const drought = 1.9 * scorch * Math.max(0, autumn - 0.45);
	return ({ edge, fed, halo, broad, mottle }, at) => {
		const light = 1 + uneven * (0.6 * broad[at] + 0.3 * mottle[at]);
		const living = mixed(scaled(green, light * (0.95 + 0.1 * halo[at])), fresh, HALO * halo[at]);
		const rimShare = 1 - smoothstep(0, TURNING_RIM, edge[at]);
		const turnTime = TURN_TIME + VEIN_DELAY * fed[at] - 0.2 * rimShare + uneven * (0.4 * broad[at] + 0.15 * mottle[at]);
		const turned = smoothstep(turnTime - FADE_TIME, turnTime + FADE_TIME, season);
		const inner = smoothstep(0, DRYING_RIM, edge[at]);
		const dryTime = Math.max(0, 0.08 + 0.5 * inner + 0.3 * fed[at] + 0.75 * broad[at] + 0.3 * mottle[at]);
		const dry = smoothstep(dryTime, dryTime + DRYING_TIME, drought);
		const blade = mixed(mixed(living, scaled(late, light), turned), scaled(BROWN, light), 0.85 * dry);
		return { blade, vein: mixed(mixed(fresh, lateVein, 0.8 * turned), BROWN, 0.4 * dry) };
	};
}

/** Multiplies a colour by a factor. */
function scaled(colour: Colour, factor: number): Colour {
	return [colour[0] * factor, colour[1] * factor, colour[2] * factor];
}
