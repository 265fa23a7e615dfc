/** Materials in glTF; keys of `extensions` are the extensions' names. */
import type { Colour } from "../plant/colour";
import { lightThrough, type Material } from "../plant/material";
import { rounded } from "./numbers";

const DECIMALS = 6;

interface TextureInfo {
	index: number;
}

/** The textures of a material, by their indices in the document. */
export interface TextureIndices {
	colour?: number;
	normal?: number;
	surface?: number;
	thickness?: number;
}

export interface GltfMaterial {
	name: string;
	pbrMetallicRoughness: object;
	normalTexture?: TextureInfo;
	occlusionTexture?: TextureInfo;
	doubleSided?: boolean;
	alphaMode?: "MASK";
	alphaCutoff?: number;
	extensions?: Record<string, object>;
}

/**
 * Converts a material to glTF.
 * @param colour the base colour, which multiplies vertex colours and the texture
 * @param thickness of the flesh in the unit of the meshes, if any
 */
export function gltfMaterial(
	material: Material,
	colour: Colour,
	thickness: number,
	textures: TextureIndices = {},
): GltfMaterial {
	const { name, roughness, doubleSided, cutout } = material;
	const extensions = extensionsOf(material, thickness, textures);
	return {
		name,
		pbrMetallicRoughness: {
			baseColorFactor: [...shortColour(colour), 1],
			...(textures.colour !== undefined ? { baseColorTexture: { index: textures.colour } } : {}),
			metallicFactor: 0,
			roughnessFactor: textures.surface === undefined ? shortNumber(roughness) : 1,
			...(textures.surface === undefined ? {} : { metallicRoughnessTexture: { index: textures.surface } }),
		},
		...(textures.normal === undefined ? {} : { normalTexture: { index: textures.normal } }),
		...(textures.surface === undefined ? {} : { occlusionTexture: { index: textures.surface } }),
		...(doubleSided ? { doubleSided } : {}),
		...(cutout ? { alphaMode: "MASK", alphaCutoff: 0.5 } : {}),
		...(Object.keys(extensions).length > 0 ? { extensions } : {}),
	};
}

/**
 * Returns the extensions of a material, by name.
 * @param thickness of the volume that light crosses, in units of the mesh; only used for flesh
 */
function extensionsOf(material: Material, thickness: number, textures: TextureIndices): Record<string, object> {
	const { sheen, ior, specular, clearcoat, flesh } = material;
	const extensions: Record<string, object> = {};
	if (sheen) {
		extensions.KHR_materials_sheen = {
			sheenColorFactor: shortColour(sheen.colour),
			sheenRoughnessFactor: shortNumber(sheen.roughness),
		};
	}
	if (ior !== undefined) extensions.KHR_materials_ior = { ior: shortNumber(ior) };
	if (specular !== undefined) extensions.KHR_materials_specular = { specularFactor: shortNumber(specular) };
	if (clearcoat) {
		const { factor, roughness } = clearcoat;
		extensions.KHR_materials_clearcoat = {
			clearcoatFactor: shortNumber(factor),
			clearcoatRoughnessFactor: shortNumber(roughness),
		};
	}
	if (flesh) {
		extensions.KHR_materials_transmission = { transmissionFactor: shortNumber(flesh.factor) };
		extensions.KHR_materials_volume = {
			thicknessFactor: shortNumber(thickness),
			...(textures.thickness === undefined ? {} : { thicknessTexture: { index: textures.thickness } }),
			attenuationColor: shortColour(flesh.colour),
			attenuationDistance: shortNumber(flesh.distance),
		};
	}
	// Flesh already describes its transmitted light.
	const through = flesh ? undefined : diffuseTransmission(material, textures);
	if (through) extensions.KHR_materials_diffuse_transmission = through;
	return extensions;
}

/**
 * Returns the transmission of a sheet; undefined for other materials. The ratio of transmitted to reflected light is
 * that of the view for each colour. Their sum is at most the incoming light, which glTF requires, so that reflected
 * light decreases by the transmitted light.
 */
function diffuseTransmission(material: Material, { colour: picture }: TextureIndices): object | undefined {
	const shares = lightThrough(material);
	// The extension ignores base colours: it gets the same picture, or the colour itself.
	const hasPicture = material.textures?.colour !== undefined && picture !== undefined;
	const colour = hasPicture ? shares : shares.map((share, k) => share * material.colour[k]);
	const greatest = Math.max(...colour);
	if (!(greatest > 0)) return undefined;
	return {
		diffuseTransmissionFactor: shortNumber(greatest / (1 + greatest)),
		diffuseTransmissionColorFactor: colour.map((value) => shortNumber(value / greatest)),
		...(hasPicture ? { diffuseTransmissionColorTexture: { index: picture } } : {}),
	};
}

/** Rounds a number for the file. */
function shortNumber(value: number): number {
	return rounded(value, DECIMALS);
}

/** Rounds a colour for the file. */
function shortColour(colour: Colour): number[] {
	return colour.map(shortNumber);
}
