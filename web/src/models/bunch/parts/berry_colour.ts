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

/** Returns the colours of all berries' vertices, and their sky visibility reduced in crevices. */
export function paintedBerries(grown: BunchPlant, surfaces: BerrySurfaces, skin: Skin): Painted {
	const painted = { colours: new Float32Array(surfaces.positions.length), sky: surfaces.sky?.slice() };
	const marks = marksOf(surfaces, skin.fruit.scar);
	for (let i = 0; i < grown.berries.count; i++) paintBerry(painted, grown, i, surfaces, skin, marks);
	return painted;
}

/**
 * Returns the marks of each vertex of the pattern, which all berries share.
 * @param scarStart value of v from which on the tip's scar lies
 */
function marksOf({ uvs }: BerrySurfaces, scarStart: number): Marks {
	const vs = Float32Array.from({ length: uvs.length / 2 }, (_, vertex) => uvs[2 * vertex + 1]);
	const scar = vs.map((v) => scarShare(v, scarStart));
	const halo = vs.map(
		(v, i) => HALO.share * smoothstep(scarStart - HALO.width, scarStart - HALO.end, v) * (1 - scar[i]),
	);
	const seat = vs.map((v) => SEAT.share * (1 - smoothstep(SEAT.from, SEAT.to, v)));
	return { marked: Uint8Array.from(scar, (value, i) => (value + halo[i] + seat[i] > 0 ? 1 : 0)), scar, halo, seat };
}

/** Paints the vertices of berry `index`. */
function paintBerry(
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
	// Values of the whole berry; those in the loop vary from vertex to vertex.
	const { unripe, ripe } = pigmentDepths(mixedWithFlesh(tint, skin, traitOf(berries, index, "set"), shrivel));
	const clear = clearness(skin, turned, shrivel);
	const { grooves, rind } = skin.fruit;
	const gilded = skin.sunned.amber * traitOf(berries, index, "exposure");
	const blotched = mix(1, RIND.least + RIND.span * FINE_MEAN, rind);
	const ball = new Ball(berries, index);
	for (let vertex = 0; vertex < scar.length; vertex++) {
		const at = 3 * (index * scar.length + vertex);
		ball.enter(positions, at);
		const coarse = ball.noise(tint.phase);
		// How ripe, mottled, sunned and waxed the berry is at this vertex; each 0 … 1.
		const share = turnedAt(turned, ball.along, coarse, skin.uneven);
		const mottle = mottleAt(coarse, skin.uneven) * blotched;
		const gilt = gilded > 0 ? gilded * share * gildedAt(ball.towards(skin.sunned.towards), coarse) : 0;
		const high = smoothstep(skin.fruit.depth[0], skin.fruit.depth[1], ball.height);
		const bloom = skin.bloom * tint.bloom * (1 - scar[vertex]);
		const rubbed = pressed[at / 3] / 255;
		// Contacts with other berries and grooves of the skin see less of the sky.
		if (sky) sky[at / 3] = Math.round(sky[at / 3] * (1 - CREVICE.pressed * rubbed) * mix(1 - CREVICE.groove, 1, high));
		const visible = sky ? Math.max(1, sky[at / 3]) / 255 : 1;
		const waxed = waxAt(bloom, coarse, normals[at + 1], rubbed, shrivel);
		for (let k = 0; k < 3; k++) {
			let colour = mottle * Math.exp(unripe[k] + (ripe[k] - unripe[k]) * share) * mix(1, AMBER.colour[k], gilt);
			// Layers over the pigments, from the innermost: grooves, marks around the stalk, light through the flesh, wax.
			if (high < 1) colour *= mix(grooves[k], 1, high);
			if (marked[vertex]) {
				colour = mix(colour, HALO.skin * colour + HALO.light, halo[vertex]);
				colour = mix(colour, SEAT.skin * colour + SEAT.colour[k], seat[vertex]);
				colour = mix(colour, SCAR.colour[k] + SCAR.skin * colour, SCAR.share * scar[vertex]);
			}
			const skinned = visible < 1 ? colour * neighbourLight(colour, k, clear, visible) : colour;
			colours[at + k] = clamp(skinned + (skin.wax[k] - skinned) * waxed);
		}
	}
}

/**
 * Mixes a berry's colours with those of its visible flesh, which has one colour in all ripe berries.
 * @param set 0 flower … 1 berry
 * @param shrivel how far the berry has dried, 0 … 1
 */
function mixedWithFlesh({ unripe, ripe }: BerryTint, skin: Skin, set: number, shrivel: number) {
	const browned = (colour: Colour) => colour.map((value, k) => value * Math.exp(-BROWNED[k] * shrivel)) as Colour;
	const shown = FLESH_ON_FACE * set * (1 - shrivel);
	return {
		unripe: mixed(unripe, browned(skin.unripe), shown * skin.unripeFlesh.translucency),
		ripe: mixed(ripe, browned(skin.ripe), shown * skin.ripeFlesh.translucency),
	};
}

/**
 * Returns how visible the flesh is through the skin, 0 … 1.
 * @param turned how far the skin has turned to its ripe colour, 0 … 1
 * @param shrivel how far the berry has dried, 0 … 1
 */
function clearness({ ripeFlesh, unripeFlesh }: Skin, turned: number, shrivel: number): number {
	return mix(unripeFlesh.translucency, ripeFlesh.translucency, turned) * (1 - 0.6 * shrivel);
}

/**
 * Returns the factor on channel `k` (0 … 2 for red, green, blue) for light reflected among clear neighbours, relative
 * to the skin's own albedo; shade is applied later.
 * @param clear how visible the flesh is, 0 … 1
 * @param visible share of the sky that the point sees
 */
function neighbourLight(albedo: number, k: number, clear: number, visible: number): number {
	return (
		bounced(visible, mix(albedo, Math.sqrt(albedo) * AMONG_CLEAR[k], clear)) / Math.max(1e-3, bounced(visible, albedo))
	);
}

/** Converts colours to pigment depths, the logarithms of their light: as such colours are mixed. */
function pigmentDepths({ unripe, ripe }: Pick<BerryTint, "unripe" | "ripe">) {
	const depth = (value: number) => Math.log(value + LEAST_LIGHT);
	return { unripe: unripe.map(depth), ripe: ripe.map(depth) };
}

/**
 * Returns how far the skin has turned to its ripe colour at a point, 0 … 1: it turns from the tip, in patches.
 * @param turned of the whole berry
 * @param along position on the axis, −1 at the pedicel … 1 at the tip
 * @param coarse noise at the point, 0 … 1
 * @param uneven the look's unevenness, 0 … 1
 */
function turnedAt(turned: number, along: number, coarse: number, uneven: number): number {
	const width = TURNING.width + TURNING.uneven * uneven;
	const late = clamp(0.5 - TURNING.along * along + TURNING.coarse * uneven * (coarse - 0.5));
	return smoothstep(0, 1, (turned * (1 + width) - late) / width);
}

/**
 * Returns how far the sun has gilded a point, 0 … 1.
 * @param towards cosine of the angle between the point's direction and the sun's
 * @param coarse noise at the point, 0 … 1
 */
function gildedAt(towards: number, coarse: number): number {
	return smoothstep(AMBER.from, AMBER.to, towards + AMBER.coarse * (coarse - 0.5));
}

/**
 * Returns the factor on the colour by mottling.
 * @param coarse noise at the point, 0 … 1
 * @param uneven the look's unevenness, 0 … 1
 */
function mottleAt(coarse: number, uneven: number): number {
	return MOTTLE.least + MOTTLE.span * mix(0.5, coarse, MOTTLE.share + MOTTLE.uneven * uneven);
}

/**
 * Returns the share of the skin that wax hides in files' colours, seen face on.
 * @param bloom of the berry, 0 … 1
 * @param coarse noise at the point, 0 … 1
 * @param up how far the normal points up, −1 … 1
 * @param pressed 0 free … 1 in contact with a neighbour
 * @param shrivel how far the berry has dried, 0 … 1, which removes wax
 */
function waxAt(bloom: number, coarse: number, up: number, pressed: number, shrivel: number): number {
	return hiddenBy(WAX_ON_FACE * waxDepth(bloom, coarse, FINE_MEAN, up, pressed)) * (1 - WAX.dry * shrivel);
}
