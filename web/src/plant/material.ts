/** What surfaces are made of, as physically based values: what the view draws and what files say. */
import { type Colour, linear } from "./colour";

/** A picture that is laid on a surface by its uv: the first row is v = 0. */
export interface Picture {
	/** In pixels. */
	width: number;
	/** In pixels. */
	height: number;
	/** 3 × width × height: red, green, blue; 4 × where it is only to be drawn (plant/picture.ts). */
	pixels: Uint8Array;
}

/** What is finer than a mesh: view and files lay the same pictures on it. */
export interface Textures {
	/** Laid one beside the other where texture coordinates go on beyond 0 … 1; else they end at their edges. */
	repeats?: boolean;
	/** sRGB: in place of the material's colour, which is its mean; colours of vertices multiply it. */
	colour?: Picture;
	/**
	 * Normals in the surface's frame, 0 … 255 for −1 … 1: red to +u, green to −v, which is up in the picture, as glTF has it
	 * ("+Y up"). Texture coordinates must not be mirrored: seen from outside, v runs down where u runs right. So
	 * normal × tangent points to −v, whoever makes the tangents.
	 */
	normal?: Picture;
	/**
	 * How much light from all around reaches it in the red channel (255 all), roughness in the green one in place of the material's, no
	 * metal in the blue one: as glTF packs them. Files alone have it.
	 */
	surface?: Picture;
	/** Of the flesh, as a share of its thickness, in the green channel. Files alone have it. */
	thickness?: Picture;
}

/** Parts that share a material share the object. Nothing of a plant is metallic. */
export interface Material {
	/** As files call it. */
	name: string;
	/** Linear light: what is shown of parts without colours of their own, and where those cannot be told. */
	colour: Colour;
	/** 0 mirror … 1 matt. */
	roughness: number;
	/** Whether wind leaves what is made of it alone: stone. */
	still?: true;
	/** Of sheets without thickness. */
	doubleSided?: boolean;
	/**
	 * Of sheets: light that comes through, as a factor on what the colour lets pass (`lightThrough`), and the colour of the
	 * other side, as a factor on this one's, which files cannot say.
	 */
	sheet?: { through: Colour; reverse: Colour };
	/** Fine fibres or wax, seen at grazing angles: linear colour and roughness. */
	sheen?: { colour: Colour; roughness: number };
	/** Refractive index, where it is not 1.5. */
	ior?: number;
	/** Factor on the mirror, where it is not 1. */
	specular?: number;
	/** A second, smooth mirror over the first. */
	clearcoat?: { factor: number; roughness: number };
	/** What is finer than the mesh, where something is. */
	textures?: Textures;
	/** Light through the flesh: its share; how thick it is; how long a way leaves how much of it (metres, linear colour). */
	flesh?: { factor: number; thickness: number; colour: Colour; distance: number };
}

/** Something fair for each kind of material that a plant's mesh may name. */
const STANDARD: Readonly<Record<string, Material>> = {
	stem: { name: "Stem", colour: linear("7d7a3f"), roughness: 0.85 },
	bark: { name: "Bark", colour: linear("6d5745"), roughness: 0.95 },
	root: { name: "Root", colour: linear("b79b74"), roughness: 0.9 },
	blade: {
		name: "Blade",
		colour: linear("4f7430"),
		roughness: 0.6,
		doubleSided: true,
		sheet: { through: [0.75, 0.85, 0.45], reverse: [1.3, 1.2, 1.4] },
	},
	petal: {
		name: "Petal",
		colour: linear("e7a9bf"),
		roughness: 0.65,
		doubleSided: true,
		sheen: { colour: [0.12, 0.1, 0.11], roughness: 0.5 },
	},
	sepal: { name: "Sepal", colour: linear("6d8f45"), roughness: 0.7, doubleSided: true },
	stamen: { name: "Stamen", colour: linear("e8d27a"), roughness: 0.7 },
	skin: { name: "Skin", colour: linear("8c2f45"), roughness: 0.38, ior: 1.4 },
};
const PLAIN: Omit<Material, "name"> = { colour: linear("86a046"), roughness: 0.75 };

/** The material of a kind that a model does not dress itself: a kind nobody has heard of is a leaf's matt green. */
export function standardMaterial(kind: string): Material {
	if (Object.hasOwn(STANDARD, kind)) return STANDARD[kind];
	return { name: kind.charAt(0).toUpperCase() + kind.slice(1), ...PLAIN };
}

/** Light that comes through a sheet as a share of what it throws back, colour by colour: what is paler lets more pass. The view does the same pixel by pixel. */
export function lightThrough({ sheet, colour }: Material): Colour {
	return (sheet?.through ?? [0, 0, 0]).map((share, k) => share * Math.sqrt(colour[k])) as Colour;
}
