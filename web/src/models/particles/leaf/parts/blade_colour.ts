/** The colours of a blade, vertex by vertex: what view and files show of it. */
import { type Colour, linear, mixed, smoothstep } from "../../../../plant/colour";
import { noise } from "../../../../plant/noise";
import type { Mesh } from "../../../../plant/plant";
import type { BladeFace } from "../grown";
import type { LeafSpecimen } from "../specimen";
import { awayAt, type VeinMap } from "./vein_map";

/** Noise cells to a metre, of broad patches and of mottling. */
const BROAD = 60;
const MOTTLE = 420;
/** Along veins the blade is paler, by this share of their colour. */
const HALO = 0.16;
/** What has turned is browned by this much in places. */
const BROWN: Colour = [0.2, 0.085, 0.025];

/** Within this of the margin a blade turns first, in lengths of the leaf. */
const RIM = 0.08;

/**
 * 3 × vertices, linear light.
 * @param hex the face's colour between veins
 */
export function bladeColours(
	{ positions, uvs }: Pick<Mesh, "positions" | "uvs">,
	{ vein: veined, edge }: BladeFace,
	map: VeinMap,
	look: LeafSpecimen["look"],
	hex: string,
): Float32Array {
	const green = linear(hex);
	const [vein, late] = [linear(look.vein_colour as string), linear(look.autumn_colour as string)];
	const rib = ribColour(look);
	const [autumn, uneven] = [look.autumn as number, look.uneven as number];
	const colours = new Float32Array(positions.length);
	for (let vertex = 0; vertex < veined.length; vertex++) {
		const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
		const [broad, mottle] = [BROAD, MOTTLE].map((cells) => noise(cells * x, cells * y, cells * z) - 0.5);
		const away = awayAt(map, uvs[2 * vertex], uvs[2 * vertex + 1]);
		const near = (1 - away) ** 2;
		const rim = 1 - smoothstep(0, RIM, edge[vertex]);
		const light = 1 + uneven * (0.6 * broad + 0.3 * mottle);
		const fresh = mixed(scaled(green, light * (0.95 + 0.1 * near)), vein, HALO * near);
		// Along veins green stays longest; the margin turns first.
		const turned = smoothstep(0.3, 0.8, autumn * (1.1 + 0.35 * away + 0.35 * rim) - 0.3 * near + 0.6 * uneven * broad);
		const dry = smoothstep(0.85, 1.25, autumn * (0.45 + 0.3 * away + 0.55 * rim) + 0.5 * mottle);
		const blade = mixed(mixed(fresh, scaled(late, light), turned), BROWN, 0.7 * dry);
		colours.set(mixed(blade, rib, 0.9 * smoothstep(0.05, 0.7, veined[vertex])), 3 * vertex);
	}
	return colours;
}

/** Of veins, as autumn leaves them. */
export function ribColour({ vein_colour, autumn_colour, autumn }: LeafSpecimen["look"]): Colour {
	const late = scaled(linear(autumn_colour as string), 0.85);
	return mixed(linear(vein_colour as string), late, 0.75 * smoothstep(0.5, 1, autumn as number));
}

function scaled(colour: Colour, factor: number): Colour {
	return colour.map((value) => value * factor) as Colour;
}
