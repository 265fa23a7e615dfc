/** Materials of surfaces with physically based values, for the view and for files. */
import { type Colour, linear } from "./colour";

/** A picture on a surface: the first row is v = 0. */
export interface Picture {
	/** In pixels. */
	width: number;
	/** In pixels. */
	height: number;
	/**
	 * 3 × width × height: red, green, blue; 4 × with coverage for materials that are cut out, and where it is only for
	 * drawing (plant/picture.ts).
	 */
	pixels: Uint8Array;
}

/** Surface detail finer than a mesh; view and files use the same pictures. */
export interface Textures {
	/** Whether pictures repeat where texture coordinates leave 0 … 1; else they end at their edges. */
	repeats?: boolean;
	/** sRGB, in place of the material's colour, which is its mean; vertex colours multiply it. */
	colour?: Picture;
	/**
	 * Normals in the surface's frame, 0 … 255 for −1 … 1: red to +u, green to −v, which is up in the picture, as in
	 * glTF ("+Y up"). Texture coordinates must not be mirrored: seen from outside, v runs down where u runs right. So
	 * normal × tangent points to −v for any way of making tangents.
	 */
	normal?: Picture;
	/**
	 * As glTF packs them: ambient light in the red channel (255 all), roughness in the green one in place of the
	 * material's, no metal in the blue one. For files only.
	 */
	surface?: Picture;
	/** Share of the flesh's thickness in the green channel. For files only. */
	thickness?: Picture;
}

/** A material; parts with the same material share the object. No part of a plant is metallic. */
export interface Material {
	/** The name in files. */
	name: string;
	/** Linear light: the colour of parts without vertex colours, and where vertex colours are not supported. */
	colour: Colour;
	/** 0 mirror … 1 matt. */
	roughness: number;
	/** Whether wind does not move it: stone. */
	still?: true;
	/** For sheets without thickness. */
	doubleSided?: boolean;
	/** Whether pixels whose colour picture has less than half coverage are left out. For files only. */
	cutout?: true;
	/**
	 * For sheets: transmitted light, as a factor on the light that the colour lets pass (`lightThrough`), and the
	 * colour of the reverse, as a factor on this side's, which files cannot hold.
	 */
	sheet?: { through: Colour; reverse: Colour };
	/** Fine fibres or wax, seen at grazing angles: linear colour and roughness. */
	sheen?: { colour: Colour; roughness: number };
	/** Refractive index; 1.5 where absent. */
	ior?: number;
	/** Factor on mirror reflection; 1 where absent. */
	specular?: number;
	/** A second, smooth mirror layer above the first. */
	clearcoat?: { factor: number; roughness: number };
	/** Detail finer than the mesh, if any. */
	textures?: Textures;
	/** Light through the flesh: its share; the thickness; the linear colour that remains after `distance` (metres). */
	flesh?: { factor: number; thickness: number; colour: Colour; distance: number };
}

/** Materials for the kinds that meshes may name. */
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

/** Returns the material of a kind for which a model has none of its own; an unknown kind is a leaf's matt green. */
export function standardMaterial(kind: string): Material {
	if (Object.hasOwn(STANDARD, kind)) return STANDARD[kind];
	return { name: kind.charAt(0).toUpperCase() + kind.slice(1), ...PLAIN };
}

/**
 * Returns the light through a sheet as a share of the reflected light, by channel: paler colours let more pass. The
 * view does the same pixel by pixel.
 */
export function lightThrough({ sheet, colour }: Material): Colour {
	return (sheet?.through ?? [0, 0, 0]).map((share, k) => share * Math.sqrt(colour[k])) as Colour;
}
