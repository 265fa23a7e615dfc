/** Materials of a bunch. docs/export.md gives the reasons for the values. */
import { type Colour, linear, mix, mixed, smoothstep, toLch } from "../../../plant/colour";
import type { Veins } from "../../../plant/leaf";
import { leafPicture } from "../../../plant/leaf_picture";
import type { Material } from "../../../plant/material";
import type { FoliagePart } from "../bunch_plant";
import type { Look } from "../specimen";
import { AUTUMN, brightestLeaf, CANE, FLOWER, LEAF, PETIOLE } from "./foliage_colour";
import type { FruitSkin } from "./fruit_skin";

/** Roughness of a smooth skin without wax, and in full bloom, which scatters the highlight. */
export const SKIN_ROUGHNESS: readonly [clean: number, bloomed: number] = [0.34, 0.46];
export const RIND_ROUGHNESS = 0.78;
const STEM_ROUGHNESS = 0.85;
/** Sheen of the bloom: wax crystals scatter a pale blue, strongest at grazing angles. */
const BLOOM_COLOUR: Colour = [0.17, 0.2, 0.26];
const BLOOM_ROUGHNESS = 0.55;
/** Index of refraction of wet flesh behind a cuticle, between water's 1.33 and wax's 1.45. */
const FLESH_IOR = 1.4;
const COAT_ROUGHNESS = 0.08;
/** Share of the specular reflection that wax scatters. */
const WAX_ON_MIRROR = 0.8;
/** Least coat worth a viewer's cost. */
const LEAST_COAT = 0.04;
/** Most transmitted light: above it berries look like glass in viewers that show only stems behind them. */
const MAX_TRANSMISSION = 0.3;
/** Least transmission worth the viewers' extra render pass. */
const LEAST_TRANSMISSION = 0.04;

/** Returns the material of the paper's berries: one colour, one skin. */
export function plainSkin(look: Look): Material {
	const [clean, bloomed] = SKIN_ROUGHNESS;
	const roughness = mix(clean, bloomed, look.bloom);
	return { name: "Skin", colour: linear(look.skin), roughness, ...bloomSheen(look.bloom) };
}

/**
 * Returns the material of natural berries.
 * @param colour mean of all of them
 * @param width of a mean berry, metres
 */
export function naturalSkin(look: Look, { rind, gloss }: FruitSkin, colour: Colour, width: number): Material {
	const sheen = bloomSheen(look.bloom);
	if (rind > 0) return { name: "Skin", colour, roughness: RIND_ROUGHNESS, ...sheen };
	const [clean, bloomed] = SKIN_ROUGHNESS;
	const coat = gloss * (1 - look.bloom);
	return {
		name: "Skin",
		colour,
		roughness: mix(clean, bloomed, look.bloom),
		ior: FLESH_IOR,
		...sheen,
		...(look.bloom > 0 ? { specular: 1 - WAX_ON_MIRROR * look.bloom } : {}),
		...(coat >= LEAST_COAT ? { clearcoat: { factor: coat, roughness: COAT_ROUGHNESS } } : {}),
		...fleshOf(look, width),
	};
}

/**
 * Returns the transmission of the flesh: one path through a mean berry gives the flesh's own colour. None where too
 * little light passes.
 * @param width of a mean berry, metres
 */
function fleshOf(look: Look, width: number): Pick<Material, "flesh"> {
	const skin = linear(look.skin);
	const factor = MAX_TRANSMISSION * look.glow * smoothstep(0.5, 0.75, toLch(skin).lightness);
	if (factor < LEAST_TRANSMISSION) return {};
	const brightest = Math.max(...skin);
	const colour = skin.map((value) => Math.max(0.02, value / brightest)) as Colour;
	return { flesh: { factor, thickness: width, colour, distance: width } };
}

/**
 * Returns the sheen of the waxy bloom; none without bloom.
 * @param bloom 0 … 1
 */
function bloomSheen(bloom: number): Pick<Material, "sheen"> {
	if (bloom <= 0) return {};
	return { sheen: { colour: BLOOM_COLOUR.map((value) => value * bloom) as Colour, roughness: BLOOM_ROUGHNESS } };
}

/**
 * Returns the material of stems.
 * @param colour mean of all stems
 */
export function stemMaterial(colour: Colour): Material {
	return { name: "Stem", colour, roughness: STEM_ROUGHNESS };
}

/**
 * Returns the materials of leaves, petioles and cane. Leaves transmit yellower light, and are paler below until they
 * turn.
 * @param autumn 0 … 1: how far leaves have turned
 * @param veins of the leaves, if known
 */
export function foliageMaterials(autumn: number, veins?: Veins): Record<FoliagePart["kind"], Material> {
	// The first patches turn long before the mean does.
	const turned = smoothstep(AUTUMN[0] - 0.25, AUTUMN[1] - 0.15, autumn);
	const reverse = LEAF.lower.map((value, k) => mix(value / LEAF.upper[k], 1, turned)) as Colour;
	const vein = mixed(LEAF.vein, LEAF.lateVein, turned);
	return {
		cane: { name: "Cane", colour: CANE, roughness: 0.9 },
		leaf: {
			name: "Leaf",
			colour: mixed(LEAF.upper, LEAF.late, turned),
			roughness: 0.6,
			specular: 0.6,
			doubleSided: true,
			sheet: { through: [0.83, 0.9, 0.45], reverse },
			...(veins ? { textures: { colour: leafPicture(veins, brightestLeaf(autumn), vein) } } : {}),
		},
		petiole: { name: "Petiole", colour: PETIOLE, roughness: STEM_ROUGHNESS },
	};
}

/** Material of flowers, thin and pale; colours of vertices distinguish their parts. */
export const FLOWERS: Material = {
	name: "Flower",
	colour: FLOWER[1].colour,
	roughness: 0.7,
	doubleSided: true,
	sheet: { through: [0.6, 0.6, 0.6], reverse: [1, 1, 1] },
};
