import { Color, DoubleSide, FrontSide, MeshPhysicalMaterial } from "three";
import type { Material } from "../plant/material";

/** What three's physically based material makes of one of ours; light through flesh is left out. */
export function standardMaterial(material: Material, coloured: boolean): MeshPhysicalMaterial {
	const { name, colour, roughness, doubleSided, sheen, ior, specular, clearcoat } = material;
	return new MeshPhysicalMaterial({
		name,
		color: coloured ? new Color(1, 1, 1) : new Color(...colour),
		vertexColors: coloured,
		roughness,
		metalness: 0,
		side: doubleSided ? DoubleSide : FrontSide,
		...(sheen ? { sheen: 1, sheenColor: new Color(...sheen.colour), sheenRoughness: sheen.roughness } : {}),
		...(ior === undefined ? {} : { ior }),
		...(specular === undefined ? {} : { specularIntensity: specular }),
		...(clearcoat ? { clearcoat: clearcoat.factor, clearcoatRoughness: clearcoat.roughness } : {}),
	});
}
