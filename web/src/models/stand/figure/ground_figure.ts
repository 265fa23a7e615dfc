/** The ground of a stand on the stage: it fades into the paper over its rim, unevenly; files, which know no paper, end with the rim. */
import { BufferAttribute } from "three";
import type { Material } from "../../../plant/material";
import { NOISE_CHUNK } from "../../../plant/noise";
import type { Part } from "../../../plant/part";
import { float } from "../../../scene/glsl";
import type { LightUniforms } from "../../../scene/light_shader";
import { PartMeshes, type PartObject } from "../../../scene/part_meshes";
import { standardMaterial } from "../../../scene/standard_material";

/** How much sooner or later than in the mean it may fade, as a share of the rim, and how many patches there are along its shorter side. */
const RAGGED = 0.9;
const PATCHES = 55;

const FADING = /* glsl */ `
#include <color_fragment>
float patchy = 0.6 * noise(vec3(onGround, 0.0)) + 0.4 * noise(vec3(2.7 * onGround, 5.0));
float left_ = 1.0 - rimShare - ${float(RAGGED)} * (patchy - 0.45) * smoothstep(0.0, 0.4, rimShare);
diffuseColor.a *= smoothstep(0.0, 0.75, left_) * (1.0 - smoothstep(0.7, 1.0, rimShare));
`;

export class GroundFigure {
	readonly object: PartObject;
	readonly #meshes: PartMeshes;
	readonly #material;

	/**
	 * @param part the ground as files have it
	 * @param rim how far out each vertex is in it
	 * @param side its shorter side, metres
	 */
	constructor(part: Part, rim: Float32Array, side: number, light: LightUniforms) {
		this.#material = fading(
			part.shape?.material as Material,
			part.shape?.mesh.colours !== undefined,
			PATCHES / side,
			light,
		);
		this.#meshes = new PartMeshes([part], { materialOf: () => this.#material });
		[this.object] = this.#meshes.objects;
		this.object.geometry.setAttribute("rim", new BufferAttribute(rim, 1));
		this.object.castShadow = false;
	}

	dispose(): void {
		this.object.removeFromParent();
		this.#meshes.dispose();
		this.#material.dispose();
	}
}

function fading(material: Material, coloured: boolean, patches: number, light: LightUniforms) {
	const made = standardMaterial(material, { light, sky: true, coloured });
	const lit = made.onBeforeCompile.bind(made);
	const key = made.customProgramCacheKey();
	// Drawn after the paper, which is drawn after the plants.
	made.transparent = true;
	made.onBeforeCompile = (shader, renderer) => {
		lit(shader, renderer);
		const varyings = "varying float rimShare;\nvarying vec2 onGround;";
		shader.uniforms.patches = { value: patches };
		shader.vertexShader = shader.vertexShader
			.replace("#include <common>", `#include <common>\nattribute float rim;\nuniform float patches;\n${varyings}`)
			.replace(
				"#include <project_vertex>",
				"#include <project_vertex>\nrimShare = rim;\nonGround = patches * position.xz;",
			);
		shader.fragmentShader = shader.fragmentShader
			.replace("#include <common>", `#include <common>\n${varyings}\n${NOISE_CHUNK}`)
			.replace("#include <color_fragment>", FADING);
	};
	made.customProgramCacheKey = () => `${key} ground`;
	return made;
}
