/** What plants of a stand are made of: three's standard material of ours, which gives way to the next level pixel by pixel. */
import type { MeshStandardMaterial } from "three";
import type { Material } from "../../../plant/material";
import type { LightUniforms } from "../../../scene/light_shader";
import { standardMaterial } from "../../../scene/standard_material";

/** Shares up to 1 show so many of the pixels, those from 1 on the others: of two levels together each pixel once. */
const DITHERED = /* glsl */ `
#include <color_fragment>
float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
if (vColor.a <= 1.0 ? grain >= vColor.a : grain < vColor.a - 1.0) discard;
`;

/** What tells finishes apart: all but the colour, which each plant has of its own. */
export function finishOf({ name: _, colour: __, ...finish }: Material, coloured: boolean): string {
	return JSON.stringify([finish, coloured]);
}

export function crowdMaterial(material: Material, coloured: boolean, light: LightUniforms): MeshStandardMaterial {
	const made = standardMaterial({ ...material, colour: [1, 1, 1] }, { light, sky: true, coloured });
	const lit = made.onBeforeCompile.bind(made);
	const key = made.customProgramCacheKey();
	made.onBeforeCompile = (shader, renderer) => {
		lit(shader, renderer);
		shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", DITHERED);
	};
	made.customProgramCacheKey = () => `${key} crowd`;
	return made;
}
