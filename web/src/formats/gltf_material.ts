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
	extensions?: Record<string, object>;
}

/**
 * @param colour the base colour, which multiplies vertex colours and the texture
 * @param thickness of the flesh in the unit of the meshes, if any
 */
export function gltfMaterial(
	material: Material,
	colour: Colour,
	thickness: number,
	textures: TextureIndices = {},
): GltfMaterial {
	const { name, roughness, doubleSided } = material;
	const extensions = extensionsOf(material, thickness, textures);
	return {
		name,
		pbrMetallicRoughness: {
			baseColorFactor: [...short(colour), 1],
			...(textures.colour !== undefined ? { baseColorTexture: { index: textures.colour } } : {}),
			metallicFactor: 0,
			roughnessFactor: textures.surface === undefined ? one(roughness) : 1,
			...(textures.surface === undefined ? {} : { metallicRoughnessTexture: { index: textures.surface } }),
		},
		...(textures.normal === undefined ? {} : { normalTexture: { index: textures.normal } }),
		...(textures.surface === undefined ? {} : { occlusionTexture: { index: textures.surface } }),
		...(doubleSided ? { doubleSided } : {}),
		...(Object.keys(extensions).length > 0 ? { extensions } : {}),
	};
}

function extensionsOf(material: Material, thickness: number, textures: TextureIndices): Record<string, object> {
	const { sheen, ior, specular, clearcoat, flesh } = material;
	const extensions: Record<string, object> = {};
	if (sheen) {
		extensions.KHR_materials_sheen = {
			sheenColorFactor: short(sheen.colour),
			sheenRoughnessFactor: one(sheen.roughness),
		};
	}
	if (ior !== undefined) extensions.KHR_materials_ior = { ior: one(ior) };
	if (specular !== undefined) extensions.KHR_materials_specular = { specularFactor: one(specular) };
	if (clearcoat) {
		const { factor, roughness } = clearcoat;
		extensions.KHR_materials_clearcoat = { clearcoatFactor: one(factor), clearcoatRoughnessFactor: one(roughness) };
	}
	if (flesh) {
		extensions.KHR_materials_transmission = { transmissionFactor: one(flesh.factor) };
		extensions.KHR_materials_volume = {
			thicknessFactor: one(thickness),
			...(textures.thickness === undefined ? {} : { thicknessTexture: { index: textures.thickness } }),
			attenuationColor: short(flesh.colour),
			attenuationDistance: one(flesh.distance),
		};
	}
	// Flesh already describes its transmitted light.
	const through = flesh ? undefined : diffuseTransmission(material, textures);
	if (through) extensions.KHR_materials_diffuse_transmission = through;
	return extensions;
}

/**
 * Transmission of a sheet. The ratio of transmitted to reflected light is that of the view for each colour. Their sum
 * is at most the incoming light, which glTF requires, so that reflected light decreases by the transmitted light.
 */
function diffuseTransmission(material: Material, { colour: picture }: TextureIndices): object | undefined {
	const shares = lightThrough(material);
	// The extension ignores base colours: it gets the same picture, or the colour itself.
	const pictured = material.textures?.colour !== undefined && picture !== undefined;
	const colour = pictured ? shares : shares.map((share, k) => share * material.colour[k]);
	const most = Math.max(...colour);
	if (!(most > 0)) return undefined;
	return {
		diffuseTransmissionFactor: one(most / (1 + most)),
		diffuseTransmissionColorFactor: colour.map((value) => one(value / most)),
		...(pictured ? { diffuseTransmissionColorTexture: { index: picture } } : {}),
	};
}

function one(value: number): number {
	return rounded(value, DECIMALS);
}

function short(colour: Colour): number[] {
	return colour.map(one);
}
