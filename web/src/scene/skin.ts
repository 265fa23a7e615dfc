import type { Look } from "../specimen/specimen";
import { clamp, fromHex, fromLch, mix, mixRgb, type Rgb, smoothstep, toLch } from "./colour";

/** What the berry's shader needs to know of a skin; all of it follows from the look's three values. */
export interface Skin {
	/** Colour of the skin seen by reflected light. */
	base: Rgb;
	/** 0: light stops at the skin (duku, longan); 1: the flesh is seen through (white grape, redcurrant). */
	translucency: number;
	/** Absorption of light on its way through one radius of flesh, per channel. */
	absorption: Rgb;
	/** Colour of the waxy bloom. */
	wax: Rgb;
	/** 0 … 1. */
	bloom: number;
	/** 0: taut and glossy; 1: a dull, leathery rind. */
	roughness: number;
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

/** Reads the nature of a skin from its colour: pale or vivid skins let light through, dark ones redden it, tan ones stop it. */
export function skinOf(look: Look): Skin {
	const base = fromHex(look.skin);
	const { lightness, chroma, hue } = toLch(base);
	const rind = rindness(lightness, chroma, hue);
	const pale = smoothstep(0.35, 0.8, lightness);
	const vivid = smoothstep(0.1, 0.2, chroma);
	// Anthocyanins pass red last of all: the darker the skin, the redder what still comes through.
	const dark = 1 - smoothstep(0.25, 0.5, lightness);
	const translucency = clamp(0.2 + 0.5 * pale + 0.4 * vivid - 0.06 * dark, 0, 1) * (1 - 0.92 * rind);
	const brightest = Math.max(base[0], base[1], base[2], 1e-3);
	const passing = mixRgb([base[0] / brightest, base[1] / brightest, base[2] / brightest], [1, 0.12, 0.16], 0.75 * dark);
	const density = mix(1.1, 0.42, pale) + 1.9 * dark;
	const absorption = passing.map((channel) => density * (0.4 - Math.log(clamp(channel, 0.02, 1)))) as Rgb;
	// Wax scatters short waves a little more; on a dark skin the blue is what the eye sees.
	const wax = mixRgb(fromLch({ lightness: 0.74, chroma: 0.04, hue: 4.75 }), mixRgb(base, [1, 1, 1], 0.72), 0.6 * pale);
	return { base, translucency, absorption, wax, bloom: clamp(look.bloom, 0, 1), roughness: rind };
}

/** A well-mixed 32-bit hash of two integers (the finaliser of MurmurHash3), as a fraction of 1. */
export function hashFraction(index: number, stream: number): number {
	let h = Math.imul(index + 1, 0x9e3779b1) ^ Math.imul(stream + 1, 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
	return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

/** How one berry differs from its neighbours. */
export interface BerryTint {
	colour: Rgb;
	/** Factor on the bloom. */
	bloom: number;
	/** 0 … 1, free use: spin about the berry's axis, place in the noise. */
	phase: number;
}

/** The tint of berry `index`: the same for ever, whatever else grows; a few berries ripen late. */
export function berryTint(skin: Skin, index: number): BerryTint {
	const centred = (stream: number) => hashFraction(index, stream) + hashFraction(index, stream + 16) - 1;
	const late = smoothstep(0.86, 1, hashFraction(index, 3));
	const own = toLch(skin.base);
	const colour = fromLch({
		lightness: own.lightness * (1 + 0.1 * centred(0)) + 0.05 * late,
		chroma: own.chroma * (1 + 0.14 * centred(1)),
		hue: own.hue + 0.11 * centred(2) + 0.16 * late * (own.hue < 0 ? 1 : 0.4),
	});
	return { colour, bloom: 1 + 0.5 * centred(4), phase: hashFraction(index, 5) };
}
