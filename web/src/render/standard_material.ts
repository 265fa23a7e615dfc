/** Converts materials to three's physically based materials, under the stage's light. */
import {
	Color,
	DoubleSide,
	FrontSide,
	MeshDepthMaterial,
	MeshPhysicalMaterial,
	MeshStandardMaterial,
	ShaderChunk,
	type Texture,
	Vector2,
	Vector3,
	Vector4,
	type WebGLProgramParametersWithUniforms,
	type WebGLRenderer,
} from "three";
import { BEND } from "../plant/crown";
import type { Material } from "../plant/material";
import { float } from "./glsl";
import { LIGHT_CHUNK, type LightUniforms } from "./light_shader";
import { pictureTexture } from "./picture_texture";
import { WIND_CHUNK, type WindUniforms } from "./wind_shader";

/** Share of both lamps' light that reaches a vertex, for renderers that compute it better than a shadow map. */
export interface LampShares {
	/**
	 * For the vertex shader, after LIGHT_CHUNK: a function `vec2 lamp_shares(vec3 point)` of key and rim light, 0 … 1.
	 */
	chunk: string;
	uniforms: Record<string, { value: unknown }>;
}

export interface PlainOptions {
	/** Whether vertices have colours (`color`), in place of the material's. */
	coloured?: boolean;
	/** Textures of the material; geometries that use them have `uv`. */
	maps?: { colour?: Texture; normal?: Texture };
}

export interface StandardOptions extends PlainOptions {
	light: LightUniforms;
	/** Whether vertices or instances have `sky`, 0 none … 1 all; if not, the whole sky is visible. */
	sky?: boolean;
	/** Whether vertices have `width`: tubes thinner than a pixel are then drawn wider. */
	thin?: boolean;
	shares?: LampShares;
	/** Crown that bends the normals of sheets outwards (plant/crown.ts); without it they keep their own. */
	crown?: CrownUniforms;
	/**
	 * Wind that moves the material's parts; without it they do not move. `userData.blown` of the material has the
	 * choice.
	 */
	wind?: WindUniforms;
}

/** Returns the uniforms of a crown: its centre, and half of its width, height and width. */
export function crownUniforms() {
	return { crownCentre: { value: new Vector3() }, crownSize: { value: new Vector3(1, 1, 1) } };
}

export type CrownUniforms = ReturnType<typeof crownUniforms>;

/**
 * Converts a material to three's physically based material, for any scene. Light through sheets and flesh is left out.
 */
export function plainMaterial(material: Material, { coloured = false, maps = {} }: PlainOptions): MeshStandardMaterial {
	const made = isPlain(material) ? new MeshStandardMaterial() : physical(material);
	made.name = material.name;
	made.side = material.doubleSided ? DoubleSide : FrontSide;
	const own = coloured || material.textures?.colour;
	made.color = own ? new Color(1, 1, 1) : new Color(...material.colour);
	made.vertexColors = coloured;
	if (maps.colour) made.map = maps.colour;
	if (maps.normal) made.normalMap = maps.normal;
	// three's tangent frame is that of u and v; our normals' green points against v.
	made.normalScale = new Vector2(1, -1);
	made.roughness = material.roughness;
	made.metalness = 0;
	return made;
}

/**
 * Converts a material for a scene lit by `StandardLights`, with hidden sky, reflections of the surroundings, and light
 * through sheets.
 */
export function standardMaterial(material: Material, options: StandardOptions): MeshStandardMaterial {
	const made = plainMaterial(material, options);
	// The map exists already, so setPicture must not make it again.
	if (made.map) made.userData.picture = material.textures?.colour;
	const sheet = material.sheet && sheetUniforms();
	made.userData.sheet = sheet;
	made.userData.blown = options.wind !== undefined;
	setSheet(made, material);
	setPicture(made, material);
	made.onBeforeCompile = (shader) => addLight(shader, sheet, options);
	const { sky = false, thin = false, shares, wind, crown } = options;
	if (thin) made.onBeforeRender = followPixels;
	const bends = sheet !== undefined && crown !== undefined;
	made.customProgramCacheKey = () =>
		JSON.stringify([sky, shares?.chunk, sheet !== undefined, wind !== undefined, bends, thin]);
	return made;
}

/**
 * Returns the uniforms of a thin surface: the light that it transmits, and the colour of its reverse side relative to
 * the front.
 */
function sheetUniforms() {
	return { sheetThrough: { value: new Vector3() }, sheetReverse: { value: new Vector3() } };
}

type SheetUniforms = ReturnType<typeof sheetUniforms>;

/** Sets the properties of a sheet's reverse side from another material. */
export function setSheet({ userData }: MeshStandardMaterial, { sheet }: Material): void {
	const uniforms = userData.sheet as SheetUniforms | undefined;
	if (!uniforms || !sheet) return;
	uniforms.sheetThrough.value.fromArray(sheet.through);
	uniforms.sheetReverse.value.fromArray(sheet.reverse);
}

/**
 * Replaces the picture of a three.js material, unless it is the same. The caller gives its meshes `uv`, and disposes
 * of the texture (`map`).
 */
export function setPicture(made: MeshStandardMaterial, { textures }: Material): void {
	const picture = textures?.colour;
	if (made.userData.picture === picture) return;
	made.userData.picture = picture;
	if ((made.map === null) !== (picture === undefined)) made.needsUpdate = true;
	made.map?.dispose();
	made.map = picture ? pictureTexture(picture, true, textures?.repeats) : null;
}

/**
 * Returns whether three's `MeshStandardMaterial` suffices: no sheen, index of refraction, specular factor or clear
 * coat.
 */
function isPlain({ sheen, ior, specular, clearcoat }: Material): boolean {
	return !sheen && ior === undefined && specular === undefined && !clearcoat;
}

/** Returns a `MeshPhysicalMaterial` with the properties that `MeshStandardMaterial` lacks. */
function physical({ sheen, ior, specular, clearcoat }: Material): MeshPhysicalMaterial {
	return new MeshPhysicalMaterial({
		...(sheen ? { sheen: 1, sheenColor: new Color(...sheen.colour), sheenRoughness: sheen.roughness } : {}),
		...(ior === undefined ? {} : { ior }),
		...(specular === undefined ? {} : { specularIntensity: specular }),
		...(clearcoat ? { clearcoat: clearcoat.factor, clearcoatRoughness: clearcoat.roughness } : {}),
	});
}

const SHARED = "directLight.color *= UNROLLED_LOOP_INDEX == 0 ? lampShares.x : lampShares.y;";
const LAMP = "getDirectionalLightInfo( directionalLight, directLight );";

const SHEET = "uniform vec3 sheetThrough;\nuniform vec3 sheetReverse;\n";

/**
 * Light of both lamps and of the surroundings on the other side, transmitted to this side: `lightThrough`
 * (plant/material.ts).
 */
const through = (sky: boolean) => /* glsl */ `
vec3 behind = lampsBehind + 0.6 * PI * diffuse_surroundings(-normal)${sky ? " * openSky" : ""};
reflectedLight.directDiffuse += sheetThrough * sqrt(diffuseColor.rgb) * BRDF_Lambert(diffuseColor.rgb) * behind;
`;

/** Light of each lamp on the other side, in its shadow: inside the loop over lamps. */
const LAMP_BEHIND = "lampsBehind += directLight.color * max(0.0, -dot(normal, directLight.direction));";

/** Outward direction of the crown where an instance is attached, in view space. */
const OUTWARDS = /* glsl */ `
vec3 attached = transformed;
#ifdef USE_INSTANCING
	attached = instanceMatrix[3].xyz;
#endif
vec3 fromCentre = (attached - crownCentre) / (crownSize * crownSize);
crownOut = mat3(modelViewMatrix) * (dot(fromCentre, fromCentre) > 0.0 ? normalize(fromCentre) : vec3(0.0, 1.0, 0.0));
`;

/** Bends the normal as `bentNormal` (plant/crown.ts). */
const BENT = `normal = normalize(mix(normal, crownOut, ${float(BEND)}));`;

/**
 * The point whose shadow is looked up is moved along the normal towards the lamp: a leaf seen from below would be in
 * its own shadow.
 */
const TOWARDS_KEY =
	"vec3 shadowWorldNormal = transformNormalByInverseViewMatrix(transformedNormal, viewMatrix);\nshadowWorldNormal *= dot(shadowWorldNormal, keyDirection) < 0.0 ? -1.0 : 1.0;";

/** Height of the view in pixels; that of pictures differs from that of the canvas. */
const viewPixels = { value: 1 };
const viewport = new Vector4();

/** Updates `viewPixels` before a drawing. */
const followPixels = (renderer: WebGLRenderer): void => {
	viewPixels.value = renderer.getCurrentViewport(viewport).w;
};

/**
 * A tube narrower than a pixel covers the centres of only some pixels, and becomes a dashed line. So it is widened to
 * `ENOUGH` pixels along its normals; but at most by the factor `WIDEST`, else the twigs of a distant tree would hide
 * its leaves (as the plants of a stand, models/stand/render/crowd_material.ts).
 */
const ENOUGH = 1.1;
const WIDEST = 3;
const WIDENED = /* glsl */ `
float metre = 0.5 * projectionMatrix[1].y * viewPixels / max(-mvPosition.z, 1e-4);
float across = width * metre;
float lacking = min(max(${float(ENOUGH)} - across, 0.0), ${float(WIDEST - 1)} * across);
if (lacking > 0.0) {
	mvPosition.xyz += 0.5 * lacking / metre * normalize(transformedNormal);
	gl_Position = projectionMatrix * mvPosition;
}
`;

/** Reflection of the surroundings, more blurred for rougher surfaces. */
const MIRRORED = /* glsl */ `
vec3 mirrored = reflect(-geometryViewDir, normal);
radiance += mix(gloss_surroundings(mirrored), diffuse_surroundings(mirrored), material.roughness);
#ifdef USE_CLEARCOAT
	clearcoatRadiance += gloss_surroundings(reflect(-geometryViewDir, clearcoatNormal));
#endif
`;

const SHADED = /* glsl */ `
reflectedLight.indirectDiffuse *= bounced(openSky, diffuseColor.rgb);
reflectedLight.indirectSpecular *= openSky;
#ifdef USE_CLEARCOAT
	clearcoatSpecularIndirect *= openSky;
#endif
`;

/**
 * Extends one of three's programs by the stage's light: reflections of the surroundings, light through sheets, visible
 * sky, shares of both lamps, and wind. Replaces `#include` lines of three's shader chunks.
 * @param sheet uniforms of a thin surface, if it is one
 */
function addLight(
	shader: WebGLProgramParametersWithUniforms,
	sheet: SheetUniforms | undefined,
	options: StandardOptions,
): void {
	const { light, sky = false, shares, wind } = options;
	const crown = sheet && options.crown;
	Object.assign(shader.uniforms, light, shares?.uniforms, sheet, crown);
	if (wind) addWind(shader, wind);
	const varyings = `${sky ? "varying float openSky;" : ""}\n${shares ? "varying vec2 lampShares;" : ""}\n`;
	shader.vertexShader = shader.vertexShader
		.replace(
			"#include <common>",
			`#include <common>\n${sky ? "attribute float sky;" : ""}\n${varyings}${shares ? LIGHT_CHUNK + shares.chunk : ""}`,
		)
		.replace(
			"#include <project_vertex>",
			`#include <project_vertex>\n${sky ? "openSky = sky;" : ""}\n${shares ? PLACED : ""}`,
		);
	if (options.thin) {
		shader.uniforms.viewPixels = viewPixels;
		shader.vertexShader = shader.vertexShader
			.replace("#include <common>", "#include <common>\nattribute float width;\nuniform float viewPixels;")
			.replace("#include <logdepthbuf_vertex>", `${WIDENED}\n#include <logdepthbuf_vertex>`);
	}
	if (sheet && !shares) {
		const own = ShaderChunk.shadowmap_vertex.replace(
			"vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );",
			TOWARDS_KEY,
		);
		shader.vertexShader = shader.vertexShader
			.replace("#include <common>", "#include <common>\nuniform vec3 keyDirection;")
			.replace("#include <shadowmap_vertex>", own);
	}
	if (crown)
		shader.vertexShader = shader.vertexShader
			.replace(
				"#include <common>",
				"#include <common>\nuniform vec3 crownCentre;\nuniform vec3 crownSize;\nvarying vec3 crownOut;",
			)
			.replace("#include <project_vertex>", `#include <project_vertex>\n${OUTWARDS}`);
	const lamps = sheet ? withLampsBehind(ShaderChunk.lights_fragment_begin) : ShaderChunk.lights_fragment_begin;
	shader.fragmentShader = shader.fragmentShader
		.replace(
			"#include <common>",
			`#include <common>\n${varyings}${sheet ? SHEET : ""}${crown ? "varying vec3 crownOut;\n" : ""}${LIGHT_CHUNK}`,
		)
		.replace("#include <normal_fragment_maps>", `#include <normal_fragment_maps>\n${crown ? BENT : ""}`)
		.replace("#include <color_fragment>", `#include <color_fragment>\n${sheet ? REVERSE : ""}`)
		.replace(
			"#include <lights_fragment_begin>",
			`${shares ? lamps.replace(LAMP, `${LAMP}\n${SHARED}`) : lamps}\n${sheet ? through(sky) : ""}`,
		)
		.replace("#include <lights_fragment_end>", `${MIRRORED}#include <lights_fragment_end>`)
		.replace("#include <aomap_fragment>", sky ? SHADED : "");
}

/** Returns the loops over lamps with the sum of their light on the other side of a sheet (`lampsBehind`). */
function withLampsBehind(lamps: string): string {
	const at = lamps.indexOf(LAMP);
	const reflected = lamps.indexOf("RE_Direct", at);
	return `vec3 lampsBehind = vec3(0.0);\n${lamps.slice(0, reflected)}${LAMP_BEHIND}\n${lamps.slice(reflected)}`;
}

/**
 * Extends one of three's programs so that the wind moves every vertex, and shadows are looked up where it then is.
 */
function addWind(shader: WebGLProgramParametersWithUniforms, wind: WindUniforms): void {
	Object.assign(shader.uniforms, wind);
	shader.vertexShader = shader.vertexShader
		.replace("#include <common>", `#include <common>\n${WIND_CHUNK}`)
		.replace("#include <project_vertex>", `${BLOWN}#include <project_vertex>\n${PROJECTED}`)
		.replace("#include <worldpos_vertex>", `#include <worldpos_vertex>\n${IN_WORLD}`);
}

/** Returns the shadow map's material for objects with `standardMaterial` and a wind. */
export function windyDepth(wind: WindUniforms): MeshDepthMaterial {
	const made = new MeshDepthMaterial();
	made.onBeforeCompile = (shader) => addWind(shader, wind);
	made.customProgramCacheKey = () => "wind";
	return made;
}

const BLOWN = /* glsl */ `
vec4 still = vec4(transformed, 1.0);
vec3 held = transformed;
#ifdef USE_INSTANCING
	still = instanceMatrix * still;
	held = instanceMatrix[3].xyz;
#endif
vec4 windy = vec4(blown(still.xyz, held), 1.0);
`;
const PROJECTED = /* glsl */ `
mvPosition = modelViewMatrix * windy;
gl_Position = projectionMatrix * mvPosition;
`;
/** Only programs that cast or receive shadows contain this code. */
const IN_WORLD = /* glsl */ `
#ifdef USE_SHADOWMAP
	worldPosition = modelMatrix * windy;
#endif
`;

/** Position of a vertex in the plant, with instances in place. */
const PLACED = /* glsl */ `
vec4 standing = vec4(transformed, 1.0);
#ifdef USE_INSTANCING
	standing = instanceMatrix * standing;
#endif
lampShares = lamp_shares(standing.xyz);
`;

const REVERSE = "if (!gl_FrontFacing) diffuseColor.rgb *= sheetReverse;";
