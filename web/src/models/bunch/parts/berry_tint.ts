/** Variation of one berry's colours from the bunch's: noise fixed by its id, sun exposure, and drying. */
import { type Colour, fromLch, linear, mixed, smoothstep, toLch } from "../../../plant/colour";
import { hashFraction } from "../../../plant/noise";
import type { BunchPlant } from "../bunch_plant";
import { traitOf } from "../traits";
import type { Skin } from "./skin";

/** State of a berry that changes its colour besides its skin. */
export interface Condition {
	/** 0 … 1 each, as in the core's traits. */
	exposure: number;
	set: number;
	shrivel: number;
}

/** Colours of one berry. */
export interface BerryTint {
	ripe: Colour;
	unripe: Colour;
	/** Factor on the bloom. */
	bloom: number;
	/** Free value 0 … 1: rotation about the berry's axis, offset in the noise. */
	phase: number;
}

/** Colour of a bud or a newly set ovary: the green of young leaves. */
const YOUNG = linear("86a046");

/** Returns the tint of the berry with that id, which depends on nothing else that grows; a few berries ripen late. */
export function berryTint(skin: Skin, id: number, { exposure, set, shrivel }: Condition): BerryTint {
	// A random value of −2 … 2 times the look's unevenness, with a mean of 0: the sum of two uniform ones.
	const centred = (stream: number) => 2 * skin.uneven * (hashFraction(id, stream) + hashFraction(id, stream + 16) - 1);
	const late = 2 * skin.uneven * smoothstep(0.86, 1, hashFraction(id, 3));
	const own = toLch(skin.ripe);
	const pale = smoothstep(0.45, 0.75, own.lightness);
	// Sun turns pale skins golden and dark ones darker; a berry in the shade stays greener or redder.
	const sunned = 2 * skin.uneven * (exposure - 0.5);
	const ripe = fromLch({
		lightness: own.lightness * (1 + 0.1 * centred(0) - 0.05 * sunned * (1 - pale)) + 0.05 * late,
		chroma: own.chroma * (1 + 0.14 * centred(1) + 0.1 * sunned * pale),
		hue: own.hue + 0.11 * centred(2) - 0.14 * sunned * pale + 0.16 * late * (own.hue < 0 ? 1 : 0.4),
	});
	const green = toLch(mixed(YOUNG, skin.unripe, set));
	const unripe = fromLch({
		lightness: green.lightness * (1 + 0.06 * centred(6)),
		chroma: green.chroma * (1 + 0.1 * centred(7)),
		hue: green.hue + 0.06 * centred(8) - 0.06 * sunned,
	});
	return {
		ripe: driedColour(ripe, shrivel),
		unripe: driedColour(unripe, shrivel),
		bloom: (1 + 0.5 * centred(4)) * (1 - 0.45 * shrivel) * (0.25 + 0.75 * set),
		phase: hashFraction(id, 5),
	};
}

/**
 * Returns a raisin's colour: browner, and darker the paler it was; pale ones are amber.
 * @param shrivel how far the berry has dried, 0 … 1
 */
function driedColour(colour: Colour, shrivel: number): Colour {
	const { lightness, chroma } = toLch(colour);
	const pale = smoothstep(0.45, 0.75, lightness);
	const raisin = fromLch({
		lightness: 0.17 + 0.32 * lightness + 0.04 * pale,
		chroma: 0.03 + 0.33 * chroma + 0.02 * pale,
		hue: 0.8 + 0.25 * pale,
	});
	return mixed(colour, raisin, 0.93 * smoothstep(0, 0.8, shrivel));
}

/** Exposure of the paper's berries, which have no sun: none differs. */
const HALF = 0.5;

/** Returns the tint of berry `index` of a bunch. */
export function tintOf({ berries, procedure }: BunchPlant, index: number, skin: Skin): BerryTint {
	return berryTint(skin, berries.ids[index], {
		exposure: procedure === "paper" ? HALF : traitOf(berries, index, "exposure"),
		set: traitOf(berries, index, "set"),
		shrivel: traitOf(berries, index, "shrivel"),
	});
}
