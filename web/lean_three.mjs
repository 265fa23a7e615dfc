import { basename } from "node:path";
import { fileURLToPath } from "node:url";

/** Programs of three's materials that nothing here wears. */
const PROGRAMS =
	"background backgroundCube cube distance equirect linedashed meshlambert meshmatcap meshnormal meshphong meshtoon shadow sprite vsm";

/**
 * Pieces of its other programs for what nothing here has: each is empty unless a switch is on. What three puts in for light
 * of the other materials is here, too.
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

/** Parts of the renderer for what nothing here asks of it, and what stands for them, by the module that exports them. */
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
	// Surroundings are ours (render/light), no texture: only what is a texture already comes back.
	WebGLEnvironments:
		"export function WebGLEnvironments() { return { get: (texture) => texture ?? null, dispose() {} }; }",
	// For lamps that throw shadows all round.
	WebGLCubeRenderTarget: "export class WebGLCubeRenderTarget {}",
	WebGLMorphtargets: "export function WebGLMorphtargets() {}",
	WebGLUniformsGroups: "export function WebGLUniformsGroups() { return { dispose() {} }; }",
	// For pictures of more than eight bits a colour.
	WebGLOutput: "export function WebGLOutput() {}",
};

/** Classes that would draw wrongly without what is left out. */
const NEEDS_MORE =
	/\/(Mesh(Lambert|Matcap|Normal|Phong|Toon)Material|LineDashedMaterial|(Sprite|Shadow)Material|SkinnedMesh|FogExp2|Fog|PointLight|PMREMGenerator)\.js$/;

const unused = new Set([...`${PROGRAMS} ${PIECES}`.split(" ").map((name) => `${name}.glsl.js`)]);
const GLSL = /\/\* glsl \*\/`([^`]*)`/g;

/** A program's text without its comments and margins, which three's own build takes out, too. */
function bare(text) {
	const lines = text.replace(/\/\*.*?\*\/|\/\/[^\n]*/gs, "").split("\n");
	return lines
		.map((line) => line.trim())
		.filter(Boolean)
		.join("\n")
		.concat("\n");
}

/**
 * three in the built pages: from its sources, so that what is not imported stays out, and without the parts of its renderer
 * that are never used, a sixth of it. Fails where three has no such part any more, or where a class is imported that needs one.
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
