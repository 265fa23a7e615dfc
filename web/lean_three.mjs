import { basename } from "node:path";
import { fileURLToPath } from "node:url";

/** Shader programs of three's materials that the app does not use. */
const PROGRAMS =
	"background backgroundCube cube distance equirect linedashed meshlambert meshmatcap meshnormal meshphong meshtoon shadow sprite vsm";

/**
 * Shader chunks of unused features: each is empty unless a switch is on. Chunks for the light of unused materials are listed,
 * too.
 */
const PIECES = [
	"alphahash_fragment alphahash_pars_fragment bumpmap_pars_fragment",
	"clipping_planes_fragment clipping_planes_pars_fragment clipping_planes_pars_vertex clipping_planes_vertex",
	"displacementmap_pars_vertex displacementmap_vertex envmap_common_pars_fragment envmap_fragment envmap_pars_fragment",
	"envmap_pars_vertex envmap_vertex fog_fragment fog_pars_fragment fog_pars_vertex fog_vertex gradientmap_pars_fragment",
	"iridescence_fragment iridescence_pars_fragment lightprobes_pars_fragment lights_lambert_fragment",
	"lights_lambert_pars_fragment lights_phong_fragment lights_phong_pars_fragment lights_toon_fragment",
	"lights_toon_pars_fragment logdepthbuf_fragment logdepthbuf_pars_fragment logdepthbuf_pars_vertex logdepthbuf_vertex",
	"map_particle_fragment map_particle_pars_fragment morphcolor_vertex morphinstance_vertex morphnormal_vertex",
	"morphtarget_pars_vertex morphtarget_vertex shadowmask_pars_fragment skinbase_vertex skinning_pars_vertex",
	"skinning_vertex skinnormal_vertex transmission_fragment transmission_pars_fragment",
].join(" ");

/** Unused modules of the renderer, with their replacements. */
const PARTS = {
	WebXRManager: `export class WebXRManager {
		enabled = false;
		isPresenting = false;
		addEventListener() {}
		removeEventListener() {}
		setAnimationLoop() {}
		getEnvironmentBlendMode() {}
		dispose() {}
	}`,
	// Environment maps are the app's own (render/light): textures are returned unchanged.
	WebGLEnvironments:
		"export function WebGLEnvironments() { return { get: (texture) => texture ?? null, dispose() {} }; }",
	// Used for shadows of point lights.
	WebGLCubeRenderTarget: "export class WebGLCubeRenderTarget {}",
	WebGLMorphtargets: "export function WebGLMorphtargets() {}",
	WebGLUniformsGroups: "export function WebGLUniformsGroups() { return { dispose() {} }; }",
	// Used for pictures of more than eight bits per channel.
	WebGLOutput: "export function WebGLOutput() {}",
};

/** Classes that need the removed parts. */
const NEEDS_MORE =
	/\/(Mesh(Lambert|Matcap|Normal|Phong|Toon)Material|LineDashedMaterial|(Sprite|Shadow)Material|SkinnedMesh|FogExp2|Fog|PointLight|PMREMGenerator)\.js$/;

const unused = new Set([...`${PROGRAMS} ${PIECES}`.split(" ").map((name) => `${name}.glsl.js`)]);
const GLSL = /\/\* glsl \*\/`([^`]*)`/g;

/** A shader's text without comments and indentation, as in three's own build. */
function bare(text) {
	const lines = text.replace(/\/\*.*?\*\/|\/\/[^\n]*/gs, "").split("\n");
	return lines
		.map((line) => line.trim())
		.filter(Boolean)
		.join("\n")
		.concat("\n");
}

/**
 * Builds three from its sources, so that unused modules stay out, and without unused parts of its renderer, a sixth of it. Fails if
 * three no longer has such a part, or if an imported class needs one.
 *
 * @returns {import("vite").Plugin}
 */
export function leanThree() {
	const left = new Set();
	return {
		name: "lean-three",
		apply: "build",
		enforce: "pre",
		config: () => ({
			resolve: {
				alias: [{ find: /^three$/, replacement: fileURLToPath(import.meta.resolve("three/src/Three.js")) }],
			},
		}),
		transform: {
			filter: { id: /\/three\/src\/renderers\// },
			handler(code, id) {
				const file = basename(id);
				const part = PARTS[basename(file, ".js")];
				if (part || unused.has(file)) left.add(file);
				if (part) return { code: part, map: null };
				if (!file.endsWith(".glsl.js")) return null;
				const text = (_, glsl) => JSON.stringify(unused.has(file) ? "" : bare(glsl));
				return { code: code.replace(GLSL, text), map: null };
			},
		},
		generateBundle(_, bundle) {
			const known = [...unused, ...Object.keys(PARTS).map((name) => `${name}.js`)];
			const gone = known.filter((file) => !left.has(file));
			if (gone.length > 0) this.error(`three has no ${gone.join(", ")} to leave out`);
			for (const chunk of Object.values(bundle)) {
				if (chunk.type !== "chunk") continue;
				const wrong = Object.entries(chunk.modules).find(
					([id, { renderedLength }]) => renderedLength > 0 && NEEDS_MORE.test(id),
				);
				if (wrong) this.error(`${wrong[0]} needs what web/lean_three.mjs leaves out`);
			}
		},
	};
}
