/**
 * Colours of natural berries, vertex by vertex, for files: like the view's skins. Details finer than vertices (fine
 * noise, lenticels) are averaged.
 */
import { type Colour, clamp, mix, mixed, smoothstep } from "../../../plant/colour";
import { bounced } from "../../../plant/shade";
import type { BerrySurfaces, BunchPlant } from "../bunch_plant";
import { traitOf } from "../traits";
import { Ball } from "./ball";
import { type BerryTint, tintOf } from "./berry_tint";
import type { Skin } from "./skin";
import {
	AMBER,
	AMONG_CLEAR,
	BROWNED,
	CREVICE,
	FLESH_ON_FACE,
	HALO,
	LEAST_LIGHT,
	MOTTLE,
	RIND,
	SCAR,
	SEAT,
	TURNING,
	WAX,
	WAX_ON_FACE,
} from "./skin_rules";
import { hiddenBy, waxDepth } from "./wax";

/** Mean of the fine noise. */
const FINE_MEAN = 0.5;
/** Width of the scar's edge in v: the distance of the pattern's rings there. */
const SCAR_EDGE = 0.02;

/** Marks on each vertex of the pattern, by v. */
interface Marks {
	/** 1 where any mark is above 0. */
	marked: Uint8Array;
	scar: Float32Array;
	halo: Float32Array;
	seat: Float32Array;
}

/** Returns the share of scar at `v`: 0 skin … 1 scar. */
export function scarShare(v: number, scar: number): number {
	return smoothstep(scar - SCAR_EDGE, scar, v);
}

/** Colours of all berries' vertices, in the order of `surfaces`. */
export interface Painted {
	/** 3 × vertices × berries, linear light, 0 … 1. */
	colours: Float32Array;
	/** Sky visibility of each vertex, reduced in crevices: 255 all, 0 none; absent if unknown. */
	sky?: Uint8Array;
}

export function paintedBerries(grown: BunchPlant, surfaces: BerrySurfaces, skin: Skin): Painted {
	const painted = { colours: new Float32Array(surfaces.positions.length), sky: surfaces.sky?.slice() };
	const marks = marksOf(surfaces, skin.fruit.scar);
	for (let i = 0; i < grown.berries.count; i++) paint(painted, grown, i, surfaces, skin, marks);
	return painted;
}

function marksOf({ uvs }: BerrySurfaces, from: number): Marks {
	const along = Float32Array.from({ length: uvs.length / 2 }, (_, vertex) => uvs[2 * vertex + 1]);
	const scar = along.map((v) => scarShare(v, from));
	const halo = along.map((v, i) => HALO.share * smoothstep(from - HALO.width, from - HALO.end, v) * (1 - scar[i]));
	const seat = along.map((v) => SEAT.share * (1 - smoothstep(SEAT.from, SEAT.to, v)));
	return { marked: Uint8Array.from(scar, (value, i) => (value + halo[i] + seat[i] > 0 ? 1 : 0)), scar, halo, seat };
}

/** Paints berry `index`. */
function paint(
	{ colours, sky }: Painted,
	grown: BunchPlant,
	index: number,
	{ positions, normals, pressed }: BerrySurfaces,
	skin: Skin,
	{ marked, scar, halo, seat }: Marks,
): void {
	const { berries } = grown;
	const tint = tintOf(grown, index, skin);
	const turned = traitOf(berries, index, "turned");
	const shrivel = traitOf(berries, index, "shrivel");
	const { unripe, ripe } = pigments(fleshed(tint, skin, traitOf(berries, index, "set"), shrivel));
	const clear = clearness(skin, turned, shrivel);
	const { grooves, rind } = skin.fruit;
	const gilded = skin.sunned.amber * traitOf(berries, index, "exposure");
	const blotched = mix(1, RIND.least + RIND.span * FINE_MEAN, rind);
	const ball = new Ball(berries, index);
	for (let vertex = 0; vertex < scar.length; vertex++) {
		const at = 3 * (index * scar.length + vertex);
		ball.enter(positions, at);
		const coarse = ball.noise(tint.phase);
		const share = turnedAt(turned, ball.along, coarse, skin.uneven);
		const mottle = mottleAt(coarse, skin.uneven) * blotched;
		const gilt = gilded > 0 ? gilded * share * gildedAt(ball.towards(skin.sunned.towards), coarse) : 0;
		const high = smoothstep(skin.fruit.depth[0], skin.fruit.depth[1], ball.height);
		const bloom = skin.bloom * tint.bloom * (1 - scar[vertex]);
		const rubbed = pressed[at / 3] / 255;
		if (sky) sky[at / 3] = Math.round(sky[at / 3] * (1 - CREVICE.pressed * rubbed) * mix(1 - CREVICE.groove, 1, high));
		const visible = sky ? Math.max(1, sky[at / 3]) / 255 : 1;
		const waxed = waxAt(bloom, coarse, normals[at + 1], rubbed, shrivel);
		for (let k = 0; k < 3; k++) {
			let colour = mottle * Math.exp(unripe[k] + (ripe[k] - unripe[k]) * share) * mix(1, AMBER.colour[k], gilt);
			if (high < 1) colour *= mix(grooves[k], 1, high);
			if (marked[vertex]) {
				colour = mix(colour, HALO.skin * colour + HALO.light, halo[vertex]);
				colour = mix(colour, SEAT.skin * colour + SEAT.colour[k], seat[vertex]);
				colour = mix(colour, SCAR.colour[k] + SCAR.skin * colour, SCAR.share * scar[vertex]);
			}
			const skinned = visible < 1 ? colour * amongClear(colour, k, clear, visible) : colour;
			colours[at + k] = clamp(skinned + (skin.wax[k] - skinned) * waxed);
		}
	}
}

/** Mixes a berry's colours with those of its visible flesh, which is of one colour in all ripe berries. */
function fleshed({ unripe, ripe }: BerryTint, skin: Skin, set: number, shrivel: number) {
	const browned = (colour: Colour) => colour.map((value, k) => value * Math.exp(-BROWNED[k] * shrivel)) as Colour;
	const shown = FLESH_ON_FACE * set * (1 - shrivel);
	return {
		unripe: mixed(unripe, browned(skin.unripe), shown * skin.unripeFlesh.translucency),
		ripe: mixed(ripe, browned(skin.ripe), shown * skin.ripeFlesh.translucency),
	};
}

/** Returns how visible the flesh is through the skin. */
function clearness({ ripeFlesh, unripeFlesh }: Skin, turned: number, shrivel: number): number {
	return mix(unripeFlesh.translucency, ripeFlesh.translucency, turned) * (1 - 0.6 * shrivel);
}

/**
 * Returns the factor on channel `k` for light reflected among clear neighbours, relative to the skin's own albedo;
 * shade is applied later.
 */
function amongClear(albedo: number, k: number, clear: number, visible: number): number {
	return (
		bounced(visible, mix(albedo, Math.sqrt(albedo) * AMONG_CLEAR[k], clear)) / Math.max(1e-3, bounced(visible, albedo))
	);
}

/** Converts colours to pigment depths. */
function pigments({ unripe, ripe }: Pick<BerryTint, "unripe" | "ripe">) {
	const depth = (value: number) => Math.log(value + LEAST_LIGHT);
	return { unripe: unripe.map(depth), ripe: ripe.map(depth) };
}

/** Returns how far the skin has turned at a position `along` the axis. */
function turnedAt(turned: number, along: number, coarse: number, uneven: number): number {
	const width = TURNING.width + TURNING.uneven * uneven;
	const late = clamp(0.5 - TURNING.along * along + TURNING.coarse * uneven * (coarse - 0.5));
	return smoothstep(0, 1, (turned * (1 + width) - late) / width);
}

/** Returns how far the sun has gilded a point that faces the sun by `towards`. */
function gildedAt(towards: number, coarse: number): number {
	return smoothstep(AMBER.from, AMBER.to, towards + AMBER.coarse * (coarse - 0.5));
}

function mottleAt(coarse: number, uneven: number): number {
	return MOTTLE.least + MOTTLE.span * mix(0.5, coarse, MOTTLE.share + MOTTLE.uneven * uneven);
}

/** Returns the share of the skin hidden by wax in files' colours, seen face on. */
function waxAt(bloom: number, coarse: number, up: number, pressed: number, shrivel: number): number {
	return hiddenBy(WAX_ON_FACE * waxDepth(bloom, coarse, FINE_MEAN, up, pressed)) * (1 - WAX.dry * shrivel);
}
