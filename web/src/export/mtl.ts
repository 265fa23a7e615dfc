/** The materials of an OBJ: MTL's own values, then the physically based ones that newer readers know. */
import { encoded } from "./colour";
import { GENERATOR } from "./generator";
import type { Material } from "./materials";
import { rounded } from "./numbers";

/** Light that a surface returns as a highlight, for readers that know no physically based values. */
const SKIN_SPECULAR = 0.25;
const SPECULAR = 0.04;

/** A material under the name that the OBJ calls it by. */
export interface NamedMaterial {
	name: string;
	material: Material;
}

/** The text; values that physically based readers know are `Pr` roughness, `Pm` metallic, `Ps` sheen, `Pc` coat. */
export function writeMtl(materials: readonly NamedMaterial[]): string {
	return [`# ${GENERATOR}\n`, ...materials.map(block)].join("\n");
}

function block({ name, material }: NamedMaterial): string {
	const { colour, roughness, sheen, clearcoat, ior } = material;
	const specular = material.name === "Skin" ? SKIN_SPECULAR : SPECULAR;
	const lines = [
		`newmtl ${name}`,
		`Kd ${encoded(colour)
			.map((value) => rounded(value, 4))
			.join(" ")}`,
		`Ks ${specular} ${specular} ${specular}`,
		// Blinn–Phong's exponent of the same width of highlight as this roughness.
		`Ns ${rounded(2 / roughness ** 4 - 2, 1)}`,
		"d 1",
		"illum 2",
		`Pr ${roughness}`,
		"Pm 0",
	];
	if (ior !== undefined) lines.push(`Ni ${ior}`);
	if (sheen) lines.push(`Ps ${Math.max(...sheen.colour)}`);
	if (clearcoat) lines.push(`Pc ${clearcoat.factor}`, `Pcr ${clearcoat.roughness}`);
	return `${lines.join("\n")}\n`;
}
