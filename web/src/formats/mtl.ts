/** The materials of an OBJ: MTL's own values, then the physically based ones that newer readers know. */
import { encoded } from "../plant/colour";
import type { Material } from "../plant/material";
import { GENERATOR } from "./generator";
import { rounded } from "./numbers";

/** The highlight of smooth and of matt surfaces, for readers without physically based values. */
const SPECULAR = { smooth: 0.25, matt: 0.04 } as const;
const SMOOTH = 0.5;
const DECIMALS = 4;
const WHITE = [1, 1, 1];

/** A material and its name in the OBJ. */
export interface NamedMaterial {
	name: string;
	material: Material;
	/** Files of pictures beside this one. */
	pictures?: { colour?: string; normal?: string };
}

/**
 * Writes the text; physically based values are `Pr` roughness, `Pm` metallic, `Ps` sheen, `Pc` coat, `norm` a picture
 * of normals.
 */
export function writeMtl(materials: readonly NamedMaterial[]): string {
	return [`# ${GENERATOR}\n`, ...materials.map(block)].join("\n");
}

/** Writes one material (`newmtl`); `pictures` are file names. */
function block({ name, material, pictures = {} }: NamedMaterial): string {
	const { colour, roughness, sheen, clearcoat, ior } = material;
	const specular = roughness < SMOOTH ? SPECULAR.smooth : SPECULAR.matt;
	const lines = [
		`newmtl ${name}`,
		// This factor multiplies the picture, or is replaced by it; without a picture it is the colour in sRGB.
		`Kd ${(pictures.colour ? WHITE : encoded(colour).map(short)).join(" ")}`,
		`Ks ${specular} ${specular} ${specular}`,
		// Blinn–Phong's exponent for a highlight as wide as with this roughness.
		`Ns ${rounded(2 / roughness ** 4 - 2, 1)}`,
		"d 1",
		"illum 2",
		`Pr ${short(roughness)}`,
		"Pm 0",
	];
	if (ior !== undefined) lines.push(`Ni ${short(ior)}`);
	if (sheen) lines.push(`Ps ${short(Math.max(...sheen.colour))}`);
	if (clearcoat) lines.push(`Pc ${short(clearcoat.factor)}`, `Pcr ${short(clearcoat.roughness)}`);
	if (pictures.colour) lines.push(`map_Kd ${pictures.colour}`);
	if (pictures.normal) lines.push(`norm ${pictures.normal}`);
	return `${lines.join("\n")}\n`;
}

/** Rounds a number for the file. */
function short(value: number): number {
	return rounded(value, DECIMALS);
}
