/** The materials of a bunch as physically based values, shared by GLB and OBJ. Why each is so is in docs/export.md. */
import type { Fruit } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import { type Colour, linear, mix, mixed, smoothstep, toLch } from "./colour";
import { rounded } from "./numbers";

export interface Material {
	name: "Skin" | "Stem" | "Leaf" | "Petiole" | "Cane" | "Stamen";
	/** Linear, 0 … 1. */
	colour: Colour;
	/** 0 mirror … 1 matt. */
	roughness: number;
	/** Of sheets without thickness. */
	doubleSided?: boolean;
	/** The waxy bloom of the skin as a sheen: linear colour and roughness. Absent where there is no bloom. */
	sheen?: { colour: Colour; roughness: number };
	/** Refractive index, where it is not glTF's 1.5. */
	ior?: number;
	/** Factor on the mirror, where it is not 1. */
	specular?: number;
	/** A second, smooth mirror over the first. */
	clearcoat?: { factor: number; roughness: number };
	/** Light through the flesh: its share, and how long a way (metres) leaves how much of it (linear colour). */
	flesh?: { factor: number; thickness: number; colour: Colour; distance: number };
}

/** A smooth skin without wax; bloom scatters the highlight up to the second figure. */
const SKIN_ROUGHNESS: readonly [clean: number, bloomed: number] = [0.34, 0.46];
const STEM_ROUGHNESS = 0.85;
/** Wax crystals scatter a pale blue, strongest at grazing angles: what a sheen lobe describes. */
const BLOOM_COLOUR: Colour = [0.17, 0.2, 0.26];
const BLOOM_ROUGHNESS = 0.55;
/** What the scar and the dried style at the tip leave of the skin's colour: a brown over any skin. */
export const SCAR_TINT: Colour = [0.42, 0.3, 0.2];

/** The paper's berries: one colour, one skin. */
export function skinMaterial(look: Look): Material {
	const [clean, bloomed] = SKIN_ROUGHNESS;
	const roughness = rounded(mix(clean, bloomed, look.bloom), 3);
	return { name: "Skin", colour: linear(look.skin), roughness, ...bloomSheen(look.bloom) };
}

/** How skins of each fruit shine. `rind`: no light passes, and no mirror; `gloss`: of a clean skin's smooth coat. */
const SKINS: Record<Fruit, { rind: boolean; gloss: number }> = {
	grape: { rind: false, gloss: 0.25 },
	currant: { rind: false, gloss: 0.9 },
	bramble: { rind: false, gloss: 0.7 },
	lychee: { rind: true, gloss: 0 },
	longan: { rind: true, gloss: 0 },
	duku: { rind: true, gloss: 0 },
};
const RIND_ROUGHNESS = 0.78;
/** Between water's 1.33 and wax's 1.45: a wet flesh behind a cuticle. */
const FLESH_IOR = 1.4;
const COAT_ROUGHNESS = 0.08;
/** In natural berries wax is in the vertices' colours already; the sheen is what it adds at grazing angles. */
const SHEEN_SHARE = 0.6;
/** Wax scatters this share of the mirror. */
const WAX_ON_MIRROR = 0.5;
/** Below this a coat is not worth a reader's time. */
const LEAST_COAT = 0.05;

/**
 * Natural berries: `colour` is what the vertices' colours multiply.
 * @param width of a mean berry, metres
 * @param thickness the same in the unit of the berries' meshes
 */
export function pressedSkin(look: Look, fruit: Fruit, colour: Colour, width: number, thickness = width): Material {
	const { rind, gloss } = SKINS[fruit];
	if (rind) return { name: "Skin", colour, roughness: RIND_ROUGHNESS, ...bloomSheen(look.bloom * SHEEN_SHARE) };
	const [clean, bloomed] = SKIN_ROUGHNESS;
	const coat = rounded(gloss * (1 - look.bloom), 3);
	return {
		name: "Skin",
		colour,
		roughness: rounded(mix(clean, bloomed, look.bloom), 3),
		ior: FLESH_IOR,
		...bloomSheen(look.bloom * SHEEN_SHARE),
		...(look.bloom > 0 ? { specular: rounded(1 - WAX_ON_MIRROR * look.bloom, 3) } : {}),
		...(coat >= LEAST_COAT ? { clearcoat: { factor: coat, roughness: COAT_ROUGHNESS } } : {}),
		...flesh(look, width, thickness),
	};
}

/** The most light that passes: more, and berries look like glass where readers see nothing but stems behind them. */
const MOST_PASSING = 0.3;
/** Below this the pass that readers need for it costs more than it shows. */
const LEAST_PASSING = 0.04;
/** One way through a mean berry leaves the flesh's own colour. */
function flesh(look: Look, width: number, thickness: number): Pick<Material, "flesh"> {
	const skin = linear(look.skin);
	const factor = rounded(MOST_PASSING * look.glow * smoothstep(0.5, 0.75, toLch(skin).lightness), 3);
	if (factor < LEAST_PASSING) return {};
	const brightest = Math.max(...skin);
	const colour = skin.map((value) => rounded(Math.max(0.02, value / brightest), 4)) as Colour;
	return { flesh: { factor, thickness, colour, distance: width } };
}

function bloomSheen(bloom: number): Pick<Material, "sheen"> {
	if (bloom <= 0) return {};
	const colour = BLOOM_COLOUR.map((value) => rounded(value * bloom, 4)) as Colour;
	return { sheen: { colour, roughness: BLOOM_ROUGHNESS } };
}

/** @param colour what the vertices' colours multiply, where there are such */
export function stemMaterial(look: Look, colour: Colour = linear(look.stem)): Material {
	return { name: "Stem", colour, roughness: STEM_ROUGHNESS };
}

/** Leaves, petioles, cane and stamens have the colours that the app draws them in. */
const LEAF = linear("4f7430");
const LEAF_LATE: Colour = [0.42, 0.27, 0.045];

/** @param autumn 0 … 1: how far leaves have turned */
export function leafMaterial(autumn: number): Material {
	const late = smoothstep(0.35, 0.85, autumn);
	const colour = mixed(LEAF, LEAF_LATE, late).map((value) => rounded(value, 6)) as Colour;
	return { name: "Leaf", colour, roughness: 0.6, doubleSided: true };
}

export const PETIOLE: Material = { name: "Petiole", colour: linear("8c8f4a"), roughness: STEM_ROUGHNESS };
/** A year old cane's bark. */
export const CANE: Material = { name: "Cane", colour: linear("7a5a3c"), roughness: 0.9 };
/** Filaments; anthers are told by the vertices' colours. */
export const STAMEN: Material = { name: "Stamen", colour: linear("e3e6bd"), roughness: 0.7 };
/** What anthers leave of that colour: pollen. */
export const ANTHER_TINT: Colour = linear("e6d37c").map((value, k) => Math.min(1, value / STAMEN.colour[k])) as Colour;

/** As glTF has it; keys of `extensions` are the extensions' names, all ratified. */
export function gltfMaterial(material: Material): { extensions?: object } {
	const { name, colour, roughness, doubleSided } = material;
	const extensions = extensionsOf(material);
	return {
		name,
		pbrMetallicRoughness: { baseColorFactor: [...colour, 1], metallicFactor: 0, roughnessFactor: roughness },
		...(doubleSided ? { doubleSided } : {}),
		...(Object.keys(extensions).length > 0 ? { extensions } : {}),
	} as { extensions?: object };
}

function extensionsOf({ sheen, ior, specular, clearcoat, flesh }: Material): Record<string, object> {
	const extensions: Record<string, object> = {};
	if (sheen) {
		extensions.KHR_materials_sheen = { sheenColorFactor: sheen.colour, sheenRoughnessFactor: sheen.roughness };
	}
	if (ior !== undefined) extensions.KHR_materials_ior = { ior };
	if (specular !== undefined) extensions.KHR_materials_specular = { specularFactor: specular };
	if (clearcoat) {
		const { factor, roughness } = clearcoat;
		extensions.KHR_materials_clearcoat = { clearcoatFactor: factor, clearcoatRoughnessFactor: roughness };
	}
	if (flesh) {
		const { factor, thickness, colour, distance } = flesh;
		extensions.KHR_materials_transmission = { transmissionFactor: factor };
		extensions.KHR_materials_volume = {
			thicknessFactor: rounded(thickness, 6),
			attenuationColor: colour,
			attenuationDistance: rounded(distance, 6),
		};
	}
	return extensions;
}
