/**
 * Renders the ground of a stand, whose rim fades irregularly into the background. In files the ground ends with the
 * rim.
 */
import { BufferAttribute, Group, type MeshStandardMaterial } from "three";
import type { Material } from "../../../plant/material";
import { NOISE_CHUNK } from "../../../plant/noise";
import type { Part } from "../../../plant/part";
import { float } from "../../../render/glsl";
import type { LightUniforms } from "../../../render/light_shader";
import { PartMeshes } from "../../../render/part_meshes";
import { standardMaterial } from "../../../render/standard_material";

/** Variation of the fading, as a share of the rim, and number of patches along the shorter side. */
const RAGGED = 0.9;
const PATCHES = 55;

const FADING = /* glsl */ `
#include <color_fragment>
float patchy = 0.6 * noise(vec3(onGround, 0.0)) + 0.4 * noise(vec3(2.7 * onGround, 5.0));
float left_ = 1.0 - rimShare - ${float(RAGGED)} * (patchy - 0.45) * smoothstep(0.0, 0.4, rimShare);
diffuseColor.a *= smoothstep(0.0, 0.75, left_) * (1.0 - smoothstep(0.7, 1.0, rimShare));
`;

export class GroundRenderer {
	readonly object = new Group();
	readonly #light: LightUniforms;
	/** Noise cells per metre. */
	readonly #patches = { value: 1 };
	/** One material for all grounds: a new material needs a new shader program, which takes many frames to compile. */
	#material: MeshStandardMaterial | undefined;
	#meshes: PartMeshes | undefined;

	constructor(light: LightUniforms) {
		this.#light = light;
	}

	/**
	 * Shows a ground in place of the last one.
	 * @param part the ground; undefined where there is none
	 * @param rim distance of each vertex into the rim, 0 … 1
	 * @param shorterSide length of its shorter side, metres
	 */
	show(part: Part | undefined, rim: Float32Array, shorterSide: number): void {
		this.#clear();
		if (!part?.shape) return;
		const { mesh, material } = part.shape;
		this.#patches.value = PATCHES / shorterSide;
		const groundMaterial = this.#materialFor(material, mesh.colours !== undefined);
		this.#meshes = new PartMeshes([part], { materialOf: () => groundMaterial });
		for (const object of this.#meshes.objects) {
			object.geometry.setAttribute("rim", new BufferAttribute(rim, 1));
			object.castShadow = false;
			this.object.add(object);
		}
	}

	/** Removes the ground from the scene and releases its graphics memory. */
	dispose(): void {
		this.#clear();
		this.object.removeFromParent();
		this.#material?.dispose();
	}

	/** Removes the shown ground. */
	#clear(): void {
		this.object.clear();
		this.#meshes?.dispose();
		this.#meshes = undefined;
	}

	/** Returns the shared material, set to a ground's colours. */
	#materialFor(material: Material, coloured: boolean): MeshStandardMaterial {
		this.#material ??= groundMaterial(material, coloured, this.#patches, this.#light);
		if (coloured) this.#material.color.set(1, 1, 1);
		else this.#material.color.fromArray(material.colour);
		if (this.#material.vertexColors !== coloured) this.#material.needsUpdate = true;
		this.#material.vertexColors = coloured;
		return this.#material;
	}
}

/** Returns the ground's material, whose rim fades into the background. */
function groundMaterial(
	material: Material,
	coloured: boolean,
	patches: { value: number },
	light: LightUniforms,
): MeshStandardMaterial {
	const made = standardMaterial(material, { light, sky: true, coloured });
	const lit = made.onBeforeCompile.bind(made);
	const key = made.customProgramCacheKey();
	// Drawn after the background, which is drawn after the plants.
	made.transparent = true;
	made.onBeforeCompile = (shader, renderer) => {
		lit(shader, renderer);
		const varyings = "varying float rimShare;\nvarying vec2 onGround;";
		shader.uniforms.patches = patches;
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
