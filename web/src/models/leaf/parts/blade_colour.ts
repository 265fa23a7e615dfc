/** The colours of a blade: fresh, in autumn, dry. What view and files show of it is made of these (face_pictures.ts). */
import { type Colour, linear, mixed, smoothstep } from "../../../plant/colour";
import type { LeafSpecimen } from "../specimen";
import type { BladeFields } from "./blade_fields";

/** Along veins the blade is paler, by this share of their colour. */
const HALO = 0.16;
/** Of what has dried up. */
const BROWN: Colour = [0.2, 0.085, 0.025];
/** How near the margin a blade turns, and dries up, before the rest: in lengths of the leaf. */
const TURNING_RIM = 0.11;
const DRYING_RIM = 0.12;
/** When a place turns that no vein feeds, and how much later one does on the widest vein: in shares of autumn. */
const TURNS = 0.4;
const FED_TURNS = 0.55;
/** How long it takes to turn, before and after: what is fed less and less fades outward. */
const FADING = 0.26;
/** The same of drying up. */
const PARCHING = 0.3;

/** Of one place, linear light. */
export interface BladeColour {
	blade: Colour;
	/** Of the veins there. */
	vein: Colour;
}

/** @param green the face's colour between veins */
export function bladeColours(
	look: LeafSpecimen["look"],
	green: Colour,
): (fields: BladeFields, at: number) => BladeColour {
	const [fresh, late] = [linear(look.vein_colour as string), linear(look.autumn_colour as string)];
	const [autumn, uneven, scorch] = [look.autumn as number, look.uneven as number, look.scorch as number];
	const lateVein = mixed(scaled(late, 0.85), fresh, 0.25);
	// From before the first place turns to after the last.
	const season = -0.45 + 1.95 * autumn;
	const drought = 1.9 * scorch * Math.max(0, autumn - 0.45);
	return ({ edge, fed, halo, broad, mottle }, at) => {
		const light = 1 + uneven * (0.6 * broad[at] + 0.3 * mottle[at]);
		const alive = mixed(scaled(green, light * (0.95 + 0.1 * halo[at])), fresh, HALO * halo[at]);
		const rim = 1 - smoothstep(0, TURNING_RIM, edge[at]);
		const turns = TURNS + FED_TURNS * fed[at] - 0.2 * rim + uneven * (0.4 * broad[at] + 0.15 * mottle[at]);
		const turned = smoothstep(turns - FADING, turns + FADING, season);
		const inner = smoothstep(0, DRYING_RIM, edge[at]);
		const dries = Math.max(0, 0.08 + 0.5 * inner + 0.3 * fed[at] + 0.75 * broad[at] + 0.3 * mottle[at]);
		const dry = smoothstep(dries, dries + PARCHING, drought);
		const blade = mixed(mixed(alive, scaled(late, light), turned), scaled(BROWN, light), 0.85 * dry);
		return { blade, vein: mixed(mixed(fresh, lateVein, 0.8 * turned), BROWN, 0.4 * dry) };
	};
}

function scaled(colour: Colour, factor: number): Colour {
	return [colour[0] * factor, colour[1] * factor, colour[2] * factor];
}
