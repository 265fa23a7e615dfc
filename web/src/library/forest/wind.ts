/**
 * Wind from vertex data, as shader code: the trunk bends with the square of the height, a branch swings by its weight
 * at its own phase, and a leaf flutters along its normal.
 */
import { Vector3 } from "three";

/** Uniforms of the wind, one object for all materials of a forest. */
export function forestWind() {
	return {
		/** Seconds. */
		windTime: { value: 0 },
		/** 0 is calm, 1 a fresh breeze. */
		windStrength: { value: 0.5 },
		/** In the coordinates of the forest; its length has no effect. */
		windDirection: { value: new Vector3(0.8, 0, 0.6) },
	};
}

export type ForestWind = ReturnType<typeof forestWind>;

/** Declarations for vertex shaders. `windData`: branch phase, branch weight, leaf phase and occlusion. */
export const WIND_DECLARATIONS = /* glsl */ `
attribute vec4 windData;
uniform float windTime;
uniform float windStrength;
uniform vec3 windDirection;
uniform float treeHeight;
varying float vOcclusion;
vec3 windOffset(vec3 place, vec3 out_, mat4 tree) {
	vec3 along = normalize(transpose(mat3(tree)) * windDirection);
	vec3 across = vec3(-along.z, 0.0, along.x);
	// Neighbouring trees sway at different times.
	float late = dot(tree[3].xyz, vec3(0.37, 0.0, 0.53));
	float h = clamp(place.y / treeHeight, 0.0, 1.0);
	float turn = 6.2831853 * windData.r + late;
	float trunk = 0.022 * treeHeight * h * h * (0.6 + 0.4 * sin(1.3 * windTime + late));
	float branch = 0.02 * treeHeight * windData.g * sin(2.1 * windTime + turn);
	float leaf = 0.03 * step(0.001, windData.b) * windData.g * sin(7.0 * windTime + 6.2831853 * windData.b + turn);
	return windStrength * (trunk * along + branch * (0.7 * along + 0.5 * across + vec3(0.0, 0.4, 0.0)) + leaf * out_);
}
`;

/** Moves a vertex; after `#include <begin_vertex>`. */
export const WIND_MOTION = /* glsl */ `
#include <begin_vertex>
vOcclusion = windData.a;
transformed += windOffset(position, normal, instanceMatrix);
`;
