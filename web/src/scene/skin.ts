import type { Fruit } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import { clamp, fromHex, fromLch, mix, mixRgb, type Rgb, smoothstep, toLch } from "./colour";
import { FRUIT_SKINS, type FruitSkin } from "./fruit_skin";

/** Flesh under a skin of one colour. */
export interface Flesh {
	/** 0: light stops at the skin (duku, longan); 1: the flesh is seen through (white grape, redcurrant). */
	translucency: number;
	/** Absorption of light on its way through one radius of flesh, per channel. */
	absorption: Rgb;
}

/** What the berry's shader needs to know of a skin. */
export interface Skin {
	/** Colours seen by reflected light. */
	ripe: Rgb;
	unripe: Rgb;
	ripeFlesh: Flesh;
	unripeFlesh: Flesh;
	/** Colour of the waxy bloom. */
	wax: Rgb;
	/** 0 … 1 each. */
	bloom: number;
	lenticels: number;
	uneven: number;
	fruit: FruitSkin;
}

/** Rinds through which no flesh shines: tan and brown ones that are not vivid (duku, longan), and brick red (lychee). */
function rindness(lightness: number, chroma: number, hue: number): number {
	const degrees = (hue * 180) / Math.PI;
	const tan = smoothstep(42, 58, degrees) * (1 - smoothstep(88, 102, degrees));
	const brick = smoothstep(22, 26, degrees) * (1 - smoothstep(32, 42, degrees));
	return Math.max(
		tan * (1 - smoothstep(0.098, 0.108, chroma)) * smoothstep(0.3, 0.45, lightness),
		brick * (1 - smoothstep(0.15, 0.17, chroma)) * smoothstep(0.46, 0.52, lightness),
	);
}

/** Pale or vivid skins let light through; dark ones, whose anthocyanins pass red last of all, redden it. */
function fleshUnder(colour: Rgb, passing: number): Flesh {
	const { lightness, chroma } = toLch(colour);
	const pale = smoothstep(0.35, 0.8, lightness);
	const vivid = smoothstep(0.1, 0.2, chroma);
	const dark = 1 - smoothstep(0.25, 0.5, lightness);
	const brightest = Math.max(colour[0], colour[1], colour[2], 1e-3);
	const own: Rgb = [colour[0] / brightest, colour[1] / brightest, colour[2] / brightest];
	const through = mixRgb(own, [1, 0.12, 0.16], 0.75 * dark);
	const density = mix(1.1, 0.42, pale) + 1.9 * dark;
	return {
		translucency: clamp((0.2 + 0.5 * pale + 0.4 * vivid - 0.06 * dark) * passing, 0, 1),
		absorption: through.map((channel) => density * (0.4 - Math.log(clamp(channel, 0.02, 1)))) as Rgb,
	};
}

/**
 * Reads the nature of a skin from the look and the kind of fruit.
 * @param guess whether the colour may tell a rind: the paper's procedure knows no fruit but the grape
 */
export function skinOf(look: Look, kind: Fruit = "grape", guess = false): Skin {
	const ripe = fromHex(look.skin);
	const unripe = fromHex(look.unripe);
	const { lightness, chroma, hue } = toLch(ripe);
	const rind = guess ? rindness(lightness, chroma, hue) : 0;
	const own = FRUIT_SKINS[kind];
	const fruit = { ...own, rind: Math.max(own.rind, rind), flesh: own.flesh * (1 - 0.92 * rind) };
	const passing = 2 * clamp(look.glow, 0, 1) * fruit.flesh;
	const pale = smoothstep(0.35, 0.8, lightness);
	// Wax scatters short waves a little more; on a dark skin the blue is what the eye sees.
	const wax = mixRgb(fromLch({ lightness: 0.74, chroma: 0.04, hue: 4.75 }), mixRgb(ripe, [1, 1, 1], 0.72), 0.6 * pale);
	return {
		ripe,
		unripe,
		ripeFlesh: fleshUnder(ripe, passing),
		unripeFlesh: fleshUnder(unripe, passing),
		wax,
		bloom: clamp(look.bloom, 0, 1),
		lenticels: clamp(look.lenticels, 0, 1),
		uneven: clamp(look.uneven, 0, 1),
		fruit,
	};
}

/** A well-mixed 32-bit hash of two integers (the finaliser of MurmurHash3), as a fraction of 1. */
export function hashFraction(index: number, stream: number): number {
	let h = Math.imul(index + 1, 0x9e3779b1) ^ Math.imul(stream + 1, 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
	return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

/** What changes a berry's colour besides its skin. */
export interface Condition {
	/** 0 … 1 each, as in the core's traits. */
	exposure: number;
	set: number;
	shrivel: number;
}

/** How one berry differs from its neighbours. */
export interface BerryTint {
	ripe: Rgb;
	unripe: Rgb;
	/** Factor on the bloom. */
	bloom: number;
	/** 0 … 1, free use: spin about the berry's axis, place in the noise. */
	phase: number;
}

/** Colour of a bud or an ovary just set: the green of young leaves. */
const YOUNG = fromHex("86a046");

/** The tint of the berry with that id: the same for ever, whatever else grows; a few berries ripen late. */
export function berryTint(skin: Skin, id: number, { exposure, set, shrivel }: Condition): BerryTint {
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
	const green = toLch(mixRgb(YOUNG, skin.unripe, set));
	const unripe = fromLch({
		lightness: green.lightness * (1 + 0.06 * centred(6)),
		chroma: green.chroma * (1 + 0.1 * centred(7)),
		hue: green.hue + 0.06 * centred(8) - 0.06 * sunned,
	});
	return {
		ripe: dried(ripe, shrivel),
		unripe: dried(unripe, shrivel),
		bloom: (1 + 0.5 * centred(4)) * (1 - 0.45 * shrivel) * (0.25 + 0.75 * set),
		phase: hashFraction(id, 5),
	};
}

/** A raisin's colour: browner, and darker the paler it was. */
function dried(colour: Rgb, shrivel: number): Rgb {
	const { lightness, chroma } = toLch(colour);
	const raisin = fromLch({ lightness: 0.2 + 0.3 * lightness, chroma: 0.03 + 0.4 * chroma, hue: 0.75 });
	return mixRgb(colour, raisin, 0.8 * clamp(shrivel, 0, 1));
}
