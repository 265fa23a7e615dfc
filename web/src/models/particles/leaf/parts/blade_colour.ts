/** The colours of a blade, vertex by vertex: what view and files show of it. */
import { type Colour, linear, mixed, smoothstep } from "../../../../plant/colour";
import { noise } from "../../../../plant/noise";
import type { LeafSpecimen } from "../specimen";

/** What is known of a blade at its vertices. */
export interface BladeChart {
	/** 3 × vertices, metres. */
	positions: Float32Array;
	/** By vertex: how much of it is vein, 0 … 1. */
	veined: Float32Array;
	/** By vertex: how far the next vein is, 0 on one … 1 as far as anywhere. */
	away: Float32Array;
}

/** Noise cells to a metre, of broad patches and of mottling. */
const BROAD = 60;
const MOTTLE = 420;
/** Along veins the blade is paler, by this share of their colour. */
const HALO = 0.16;
/** What has turned is browned by this much in places. */
const BROWN: Colour = [0.2, 0.085, 0.025];

/**
 * 3 × vertices, linear light.
 * @param face the colour between veins: the upper or the lower face's
 */
export function bladeColours(
	{ positions, veined, away }: BladeChart,
	look: LeafSpecimen["look"],
	face: string,
): Float32Array {
	const green = linear(face);
	const [vein, late] = [linear(look.vein_colour as string), linear(look.autumn_colour as string)];
	const [autumn, uneven] = [look.autumn as number, look.uneven as number];
	const colours = new Float32Array(positions.length);
	for (let vertex = 0; vertex < veined.length; vertex++) {
		const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
		const [broad, mottle] = [BROAD, MOTTLE].map((cells) => noise(cells * x, cells * y, cells * z) - 0.5);
		const near = (1 - away[vertex]) ** 2;
		const light = 1 + uneven * (0.7 * broad + 0.35 * mottle);
		const fresh = mixed(scaled(green, light * (0.93 + 0.12 * near)), vein, HALO * near);
		// Veins keep their green longest.
		const turned = smoothstep(0.25, 0.75, autumn * (1.15 + 0.45 * away[vertex]) - 0.35 * near + 0.5 * uneven * broad);
		const dry = smoothstep(0.75, 1.15, autumn * (0.55 + 0.5 * away[vertex]) + 0.35 * mottle);
		const blade = mixed(mixed(fresh, scaled(late, light), turned), BROWN, 0.6 * dry);
		const rib = mixed(vein, scaled(late, 0.85), 0.75 * smoothstep(0.5, 1, autumn));
		colours.set(mixed(blade, rib, 0.85 * smoothstep(0.15, 0.85, veined[vertex])), 3 * vertex);
	}
	return colours;
}

function scaled(colour: Colour, factor: number): Colour {
	return colour.map((value) => value * factor) as Colour;
}
