/**
 * Material of a stand's plants: three's standard material with dithered fading between levels, a least width on the
 * screen, and swaying of each plant about its own base.
 */
import { MeshDepthMaterial, type MeshStandardMaterial, Vector4 } from "three";
import type { Material } from "../../../plant/material";
import { float } from "../../../render/glsl";
import type { LightUniforms } from "../../../render/light_shader";
import { standardMaterial } from "../../../render/standard_material";
import { WIND_CHUNK, type WindUniforms } from "../../../render/wind_shader";

/** Dithering: shows the share of the pixels that `vColor.a` gives. */
const DITHERED = /* glsl */ `
#include <color_fragment>
float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
if (grain >= vColor.a) discard;
`;

/**
 * The last row of a plant's matrix, otherwise constant, holds data for wind: the vector from the plant to the base
 * that it sways about (of an attached plant its parent's), and the size of the swaying plant.
 */
const STEM = /* glsl */ `
#include <batching_vertex>
vec4 stem = vec4(batchingMatrix[0].w, batchingMatrix[1].w, batchingMatrix[2].w, batchingMatrix[3].w);
batchingMatrix[0].w = batchingMatrix[1].w = batchingMatrix[2].w = 0.0;
batchingMatrix[3].w = 1.0;
`;

/** Phase delay of the wind per plant size of distance, radians. */
const LATER = 1.1;

/**
 * Geometry narrower than a pixel covers the centres of only some pixels: a stem becomes a dashed line. So it is
 * widened to about a pixel across its margin and along its normal, since coarse stems are flat ribbons; but at most by
 * the factor `WIDEST`, else twigs of distant trees would hide the leaves. The width at a vertex is the largest around
 * it; the mean between vertices is half of it.
 */
const WIDEST = 4;
const ENOUGH = 1.3;
const WIDENED = /* glsl */ `
float metre = 0.5 * projectionMatrix[1].y * viewPixels / max(-mvPosition.z, 1e-4);
float across = edgeNormal.w * edgeNormal.w * length(batchingMatrix[0].xyz) * metre;
float lacking = min(clamp(${float(ENOUGH)} - 0.5 * across, 0.0, 1.0), ${float(WIDEST - 1)} * across);
if (lacking > 0.0) {
	vec3 out_ = normal + edgeNormal.xyz * (1.0 - max(0.0, dot(normal, edgeNormal.xyz)));
	mvPosition.xyz += 0.5 * lacking / metre * mat3(modelViewMatrix) * (mat3(batchingMatrix) * out_ / length(batchingMatrix[0].xyz));
}
`;

const SWAYING = /* glsl */ `
vec4 windy = batchingMatrix * vec4(transformed, 1.0);
if (windBeat != vec2(0.0)) {
	vec3 foot = batchingMatrix[3].xyz + stem.xyz;
	float late = ${float(LATER)} * dot(vec2(0.8, 0.6), foot.xz) / stem.w;
	float c = cos(late), s = sin(late);
	vec2 beat = vec2(c * windBeat.x - s * windBeat.y, c * windBeat.y + s * windBeat.x);
	windy.xyz = swung(windy.xyz, windy.xyz, foot, vec4(1.0, stem.www), beat);
}
vec4 mvPosition = modelViewMatrix * windy;
${WIDENED}
gl_Position = projectionMatrix * mvPosition;
`;
const IN_WORLD = /* glsl */ `
#include <worldpos_vertex>
#ifdef USE_SHADOWMAP
	worldPosition = modelMatrix * windy;
#endif
`;

const viewport = new Vector4();

/**
 * Returns the key of a finish: all properties of a material except name and colour, which each plant has for itself.
 */
export function finishOf({ name: _, colour: __, ...finish }: Material, coloured: boolean): string {
	return JSON.stringify([finish, coloured]);
}

/**
 * Creates the material. Its colour is white: the batch gives each plant its own.
 * @param coloured whether the meshes have vertex colours
 */
export function crowdMaterial(
	material: Material,
	coloured: boolean,
	light: LightUniforms,
	wind: WindUniforms,
): MeshStandardMaterial {
	const swaying = standardMaterial({ ...material, colour: [1, 1, 1] }, { light, sky: true, coloured });
	const compileLit = swaying.onBeforeCompile.bind(swaying);
	const key = swaying.customProgramCacheKey();
	const viewPixels = { value: 1 };
	// The size of the drawing buffer varies: downloaded pictures are larger than the view.
	swaying.onBeforeRender = (renderer) => {
		viewPixels.value = renderer.getCurrentViewport(viewport).w;
	};
	swaying.onBeforeCompile = (shader, renderer) => {
		compileLit(shader, renderer);
		Object.assign(shader.uniforms, wind, { viewPixels });
		shader.vertexShader = shader.vertexShader
			.replace(
				"#include <common>",
				`#include <common>\nattribute vec4 edgeNormal;\nuniform float viewPixels;\n${WIND_CHUNK}`,
			)
			.replace("#include <batching_vertex>", STEM)
			.replace("#include <project_vertex>", SWAYING)
			.replace("#include <worldpos_vertex>", IN_WORLD);
		shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", DITHERED);
	};
	swaying.customProgramCacheKey = () => `${key} crowd`;
	return swaying;
}

/**
 * Creates the material for the shadow map, without wind: drawing thousands of swaying plants twice a frame costs more
 * than the visible difference justifies.
 */
export function crowdDepth(): MeshDepthMaterial {
	const depthMaterial = new MeshDepthMaterial();
	depthMaterial.onBeforeCompile = (shader) => {
		shader.vertexShader = shader.vertexShader.replace("#include <batching_vertex>", STEM);
	};
	depthMaterial.customProgramCacheKey = () => "crowd";
	return depthMaterial;
}
