/**
 * Octahedral impostors: a square that faces the camera shows the tree from pictures of a hemisphere of directions. The
 * picture of a direction is where the octahedron of all directions, folded flat, has it; three neighbouring pictures
 * are mixed (Brucks 2018).
 */
import { type BufferGeometry, MeshStandardMaterial, PlaneGeometry, Vector3 } from "three";
import { FADE_DECLARATIONS, FADE_FRAGMENT, FADE_VERTEX } from "./fade";
import type { Impostor } from "./game_tree";

/** Returns the square of an impostor: its corners are at −1 and 1. */
export const impostorGeometry = (): BufferGeometry => new PlaneGeometry(2, 2);

/**
 * Pixels with less coverage than the lower limit are left out, and those with more than the upper one are drawn. Of those
 * between, a share is drawn, in the pattern of fading: distant crowns stay as open as they are.
 */
const LIMITS = [0.15, 0.75] as const;

const VERTEX = /* glsl */ `
#include <begin_vertex>
mat4 placed = modelMatrix * instanceMatrix;
vec3 eye = (inverse(placed) * vec4(cameraPosition, 1.0)).xyz;
vec3 towards = normalize(eye - impostorCentre);
vec3 sideways = abs(towards.y) > 0.9999 ? vec3(1.0, 0.0, 0.0) : normalize(cross(vec3(0.0, 1.0, 0.0), towards));
transformed = impostorCentre + impostorRadius * (position.x * sideways + position.y * cross(towards, sideways));
vPlace = transformed;
vEye = eye;
`;

const DECLARATIONS = /* glsl */ `
uniform sampler2D impostorSurface;
uniform vec3 impostorCentre;
uniform float impostorRadius;
uniform float impostorFrames;
varying vec3 vPlace;
varying vec3 vEye;
varying mat3 vTurn;
varying float vFade;
/** Place of a direction in the grid, 0 … 1. */
vec2 gridPlace(vec3 direction) {
	vec3 d = vec3(direction.x, max(direction.y, 0.0), direction.z);
	d /= abs(d.x) + abs(d.y) + abs(d.z);
	return 0.5 + 0.5 * vec2(d.x + d.z, d.x - d.z);
}
/** Direction of a place in the grid. */
vec3 gridDirection(vec2 place) {
	vec2 p = 2.0 * place - 1.0;
	vec3 d = vec3(0.5 * (p.x + p.y), 0.0, 0.5 * (p.x - p.y));
	d.y = 1.0 - abs(d.x) - abs(d.z);
	return normalize(d);
}
/** A horizontal direction across a direction of view. */
vec3 sidewaysOf(vec3 towards) {
	return abs(towards.y) > 0.9999 ? vec3(1.0, 0.0, 0.0) : normalize(cross(vec3(0.0, 1.0, 0.0), towards));
}
/** Normal in a picture, from its coordinates in the view of the picture. */
vec3 frameNormal(vec2 frame, vec2 at) {
	vec3 towards = gridDirection(frame / (impostorFrames - 1.0));
	vec3 sideways = sidewaysOf(towards);
	vec2 n = 2.0 * texture2D(impostorSurface, at).xy - 1.0;
	return n.x * sideways + n.y * cross(towards, sideways) + sqrt(max(0.0, 1.0 - dot(n, n))) * towards;
}
/** Place in the atlas where a ray from the eye meets the plane of a picture. */
vec2 framePlace(vec2 frame, vec3 eye, vec3 ray) {
	vec3 towards = gridDirection(frame / (impostorFrames - 1.0));
	vec3 sideways = sidewaysOf(towards);
	vec3 met = eye + ray * (dot(impostorCentre - eye, towards) / dot(ray, towards)) - impostorCentre;
	vec2 inside = 0.5 + 0.5 * vec2(dot(met, sideways), dot(met, cross(towards, sideways))) / impostorRadius;
	inside = clamp(inside, 0.002, 0.998);
	// The first row of pictures is the upper one.
	return vec2(frame.x + inside.x, impostorFrames - 1.0 - frame.y + inside.y) / impostorFrames;
}
`;

const COLOUR = /* glsl */ `
vec3 ray = normalize(vPlace - vEye);
vec2 grid = gridPlace(normalize(vEye - impostorCentre)) * (impostorFrames - 1.0);
vec2 first = min(floor(grid), impostorFrames - 2.0);
vec2 rest = grid - first;
vec2 second = first + (rest.x > rest.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
float most = max(rest.x, rest.y), least = min(rest.x, rest.y);
vec2 at0 = framePlace(first, vEye, ray);
vec2 at1 = framePlace(second, vEye, ray);
vec2 at2 = framePlace(first + 1.0, vEye, ray);
vec3 shares = vec3(1.0 - most, most - least, least);
vec4 c0 = texture2D(map, at0), c1 = texture2D(map, at1), c2 = texture2D(map, at2);
vec4 mixedColour = vec4(
	(shares.x * c0.a * c0.rgb + shares.y * c1.a * c1.rgb + shares.z * c2.a * c2.rgb),
	dot(shares, vec3(c0.a, c1.a, c2.a))
);
if (mixedColour.a < mix(${LIMITS[0]}, ${LIMITS[1]}, grain)) discard;
diffuseColor.rgb *= mixedColour.rgb / mixedColour.a;
`;

const NORMAL = /* glsl */ `
#include <normal_fragment_maps>
normal = normalize(vTurn * (shares.x * frameNormal(first, at0) + shares.y * frameNormal(second, at1) +
	shares.z * frameNormal(first + 1.0, at2)));
`;

/** Creates the material of an impostor. */
export function impostorMaterial(impostor: Impostor): MeshStandardMaterial {
	const { colour, surface, frames, middle, radius } = impostor;
	colour.colorSpace = "srgb";
	for (const picture of [colour, surface]) picture.flipY = true;
	const material = new MeshStandardMaterial({ map: colour, roughness: 0.85, metalness: 0 });
	material.onBeforeCompile = (shader) => {
		Object.assign(shader.uniforms, {
			impostorSurface: { value: surface },
			impostorCentre: { value: new Vector3(...middle) },
			impostorRadius: { value: radius },
			impostorFrames: { value: frames },
		});
		shader.vertexShader = shader.vertexShader
			.replace("#include <common>", `#include <common>\n${FADE_DECLARATIONS}${VERTEX_DECLARATIONS}`)
			.replace("#include <begin_vertex>", `${VERTEX}vTurn = normalMatrix * mat3(instanceMatrix);${FADE_VERTEX}`);
		shader.fragmentShader = shader.fragmentShader
			.replace("#include <common>", `#include <common>\n${DECLARATIONS}`)
			.replace("void main() {", `void main() {\n${FADE_FRAGMENT}`)
			.replace("#include <map_fragment>", COLOUR)
			.replace("#include <normal_fragment_maps>", NORMAL);
	};
	material.customProgramCacheKey = () => "panicle impostor";
	return material;
}

const VERTEX_DECLARATIONS = /* glsl */ `
uniform vec3 impostorCentre;
uniform float impostorRadius;
varying vec3 vPlace;
varying vec3 vEye;
varying mat3 vTurn;
`;
