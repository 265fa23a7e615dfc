/** Materials of a forest's trees: those of the file, with wind, occlusion, light through leaves, and fading levels. */
import { DoubleSide, MeshDepthMaterial, type MeshStandardMaterial, RGBADepthPacking, ShaderChunk } from "three";
import { FADE_DECLARATIONS, FADE_FRAGMENT, FADE_VERTEX } from "./fade";
import { type ForestWind, WIND_DECLARATIONS, WIND_MOTION } from "./wind";

/** The share of the sun's light that passes through a leaf. */
const THROUGH = 0.35;

const OCCLUSION = /* glsl */ `
#include <aomap_fragment>
reflectedLight.indirectDiffuse *= vOcclusion;
`;

/** Light of suns behind a leaf. Without shadows, because a leaf casts one on its own back. */
const LIGHT_THROUGH = /* glsl */ `
#include <lights_fragment_end>
#if NUM_DIR_LIGHTS > 0
	for (int i = 0; i < NUM_DIR_LIGHTS; i++) {
		float behind = max(0.0, dot(-geometryNormal, directionalLights[i].direction));
		reflectedLight.directDiffuse += ${THROUGH} * vOcclusion * behind * directionalLights[i].color * BRDF_Lambert(material.diffuseColor);
	}
#endif
`;

/** Normals of leaf cards point out of the crown: both sides use them as they are. */
const CROWN_NORMALS = ShaderChunk.normal_fragment_begin.replace("normal *= faceDirection;", "");

/** Shader code of materials, as `onBeforeCompile` gets it. */
type Shader = Parameters<MeshStandardMaterial["onBeforeCompile"]>[0];

/** Adds wind and fading to the vertex shader, and fading to the fragment shader. */
function addMotion(shader: Shader, wind: ForestWind, height: number): void {
	Object.assign(shader.uniforms, wind, { treeHeight: { value: height } });
	shader.vertexShader = shader.vertexShader
		.replace("#include <common>", `#include <common>\n${FADE_DECLARATIONS}${WIND_DECLARATIONS}`)
		.replace("#include <begin_vertex>", WIND_MOTION + FADE_VERTEX);
	shader.fragmentShader = shader.fragmentShader
		.replace("#include <common>", "#include <common>\nvarying float vFade;\nvarying float vOcclusion;")
		.replace("void main() {", `void main() {\n${FADE_FRAGMENT}`);
}

/**
 * Creates the material of an instanced tree from a material of its file. Vertex colours are wind data, so that they do
 * not colour the tree; the fourth one is the occlusion.
 * @param height of the tree, metres
 */
export function treeMaterial(source: MeshStandardMaterial, wind: ForestWind, height: number): MeshStandardMaterial {
	const material = source.clone();
	const isSheet = source.side === DoubleSide;
	material.vertexColors = false;
	material.onBeforeCompile = (shader) => {
		addMotion(shader, wind, height);
		shader.fragmentShader = shader.fragmentShader.replace("#include <aomap_fragment>", OCCLUSION);
		if (isSheet)
			shader.fragmentShader = shader.fragmentShader
				.replace("#include <normal_fragment_begin>", CROWN_NORMALS)
				.replace("#include <lights_fragment_end>", LIGHT_THROUGH);
	};
	material.customProgramCacheKey = () => `panicle tree ${isSheet}`;
	return material;
}

/** Creates the material for shadow maps, with the same wind, fading and cut-outs. */
export function treeDepth(source: MeshStandardMaterial, wind: ForestWind, height: number): MeshDepthMaterial {
	const material = new MeshDepthMaterial({
		depthPacking: RGBADepthPacking,
		map: source.map,
		alphaTest: source.alphaTest,
		side: source.side,
	});
	material.onBeforeCompile = (shader) => addMotion(shader, wind, height);
	material.customProgramCacheKey = () => "panicle tree depth";
	return material;
}
