import { type Colour, clamp, fromLch, linear, mix, mixed, smoothstep, toLch } from "../../../plant/colour";
import type { BunchPlant, Fruit } from "../bunch_plant";
import type { BunchSpecimen, Look } from "../specimen";
import { FRUIT_SKINS, type FruitSkin } from "./fruit_skin";

/** Optical properties of the flesh under a skin. */
export interface Flesh {
	/** 0: opaque at the skin (duku, longan); 1: transparent flesh (white grape, redcurrant). */
	translucency: number;
	/** Absorption of light along one radius of flesh, per channel. */
	absorption: Colour;
}

/** Properties of a skin. */
export interface Skin {
	/** Colours in reflected light. */
	ripe: Colour;
	unripe: Colour;
	ripeFlesh: Flesh;
	unripeFlesh: Flesh;
	/** Colour of the waxy bloom. */
	wax: Colour;
	/** 0 … 1 each. */
	bloom: number;
	lenticels: number;
	uneven: number;
	fruit: FruitSkin;
	sunned: Sunned;
}

/** Direction of the sun and its effect on a skin. */
export interface Sunned {
	/** Unit vector towards the sun. */
	towards: [x: number, y: number, z: number];
	/** 0 … 1: how far skins in full sun turn amber. */
	amber: number;
}

/** Look of a bunch, and the sun it grew in, if known. */
export type BunchDress = Pick<BunchSpecimen, "look"> & {
	parameters?: Pick<BunchSpecimen["parameters"], "sun" | "sun_height" | "sunlight">;
};

/**
 * Returns how far a colour is that of an opaque rind, 0 … 1: tan and brown without vividness (duku, longan), or brick
 * red (lychee).
 * @param hue radians; the three are coordinates in Oklch
 */
function rindness(lightness: number, chroma: number, hue: number): number {
	const degrees = (hue * 180) / Math.PI;
	const tan = smoothstep(42, 58, degrees) * (1 - smoothstep(88, 102, degrees));
	const brick = smoothstep(22, 26, degrees) * (1 - smoothstep(32, 42, degrees));
	return Math.max(
		tan * (1 - smoothstep(0.098, 0.108, chroma)) * smoothstep(0.3, 0.45, lightness),
		brick * (1 - smoothstep(0.15, 0.17, chroma)) * smoothstep(0.46, 0.52, lightness),
	);
}

/** Light transmitted by a hard unripe berry, as a share of a ripe berry of its colour. */
const HARD = 0.5;

/**
 * Returns the flesh under a colour: pale or vivid skins transmit light; dark ones redden it, since anthocyanins absorb
 * red least.
 * @param transmission factor on the translucency; 1 for a look with half glow
 */
function fleshUnder(colour: Colour, transmission: number): Flesh {
	const { lightness, chroma } = toLch(colour);
	const pale = smoothstep(0.35, 0.8, lightness);
	const vivid = smoothstep(0.1, 0.2, chroma);
	const dark = 1 - smoothstep(0.25, 0.5, lightness);
	const brightest = Math.max(colour[0], colour[1], colour[2], 1e-3);
	const saturated: Colour = [colour[0] / brightest, colour[1] / brightest, colour[2] / brightest];
	const through = mixed(saturated, [1, 0.12, 0.16], 0.75 * dark);
	const density = mix(1.1, 0.42, pale) + 1.9 * dark;
	return {
		translucency: clamp((0.2 + 0.5 * pale + 0.4 * vivid - 0.06 * dark) * transmission),
		absorption: through.map((channel) => density * (0.4 - Math.log(clamp(channel, 0.02, 1)))) as Colour,
	};
}

/**
 * Derives a skin from the look and the kind of fruit.
 * @param guess whether to infer a rind from the colour, since the paper's procedure has no fruit but the grape
 */
export function skinOf(look: Look, kind: Fruit = "grape", guess = false): Skin {
	const ripe = linear(look.skin);
	const unripe = linear(look.unripe);
	const { lightness, chroma, hue } = toLch(ripe);
	const rind = guess ? rindness(lightness, chroma, hue) : 0;
	const fruitSkin = FRUIT_SKINS[kind];
	const fruit = { ...fruitSkin, rind: Math.max(fruitSkin.rind, rind), flesh: fruitSkin.flesh * (1 - 0.92 * rind) };
	const transmission = 2 * clamp(look.glow) * fruit.flesh;
	const pale = smoothstep(0.35, 0.8, lightness);
	// Wax scatters short waves a little more, which is visible on dark skins.
	const wax = mixed(fromLch({ lightness: 0.74, chroma: 0.04, hue: 4.75 }), mixed(ripe, [1, 1, 1], 0.72), 0.6 * pale);
	return {
		ripe,
		unripe,
		ripeFlesh: fleshUnder(ripe, transmission),
		unripeFlesh: fleshUnder(unripe, HARD * transmission),
		wax,
		bloom: clamp(look.bloom),
		lenticels: clamp(look.lenticels),
		uneven: clamp(look.uneven),
		fruit,
		sunned: NO_SUN,
	};
}

/** Default: no sun. */
const NO_SUN: Sunned = { towards: [0, 1, 0], amber: 0 };
/** Factor on gilding; the default of sunlight is 0.4. */
const GILDING = 1.6;

/** Returns the sun's effect: clear pale skins turn amber; dark ones and rinds hide it. */
function sunnedBy(parameters: NonNullable<BunchDress["parameters"]>, { ripe, uneven, fruit }: Skin): Sunned {
	const turn = (parameters.sun * Math.PI) / 180;
	const height = (parameters.sun_height * Math.PI) / 180;
	const flat = Math.cos(height);
	const { lightness, hue } = toLch(ripe);
	// Only hues from yellow on: a rosy skin reddens in the sun.
	const golden = smoothstep(1.2, 1.6, hue) * smoothstep(0.55, 0.75, lightness);
	const amber = clamp(GILDING * parameters.sunlight * (0.4 + uneven)) * golden * (1 - fruit.rind);
	return { towards: [flat * Math.sin(turn), Math.sin(height), flat * Math.cos(turn)], amber };
}

/** Returns the skin of a bunch's berries. */
export function bunchSkin(
	{ form, procedure }: Pick<BunchPlant, "form" | "procedure">,
	{ look, parameters }: BunchDress,
): Skin {
	const skin = skinOf(look, form.fruit, procedure === "paper");
	return procedure === "natural" && parameters ? { ...skin, sunned: sunnedBy(parameters, skin) } : skin;
}
