/** The 3-D view of any plant: camera, light, frames. */
const SRC = "web/src/render";
const TESTS = "tests/web/render";

export default [
	{
		file: "web/src/render/cut_out.ts",
		suites: ["tests/web/render/cut_out.test.ts"],
		faults: [
			{
				id: "cut-out-edges-dark",
				find: "(255 * onBlack[pixel + k]) / cover",
				replace: "onBlack[pixel + k]",
				breaks: "a plant that is cut out has a dark rim",
			},
		],
	},
	{
		file: `${SRC}/camera_controller.ts`,
		suites: [`${TESTS}/camera_controller.test.ts`],
		faults: [
			{
				id: "turntable-orbit-reversed",
				find: "angles.theta -= right;",
				replace: "angles.theta += right;",
				breaks: "the plant turns against the arrow keys",
			},
			{
				id: "turntable-tilt-reversed",
				find: "angles.phi - down,",
				replace: "angles.phi + down,",
				breaks: "the plant tilts against the arrow keys",
			},
			{
				id: "turntable-out-of-sight",
				find: "const correction = fromCentre.setLength(-excess);",
				replace: "const correction = fromCentre.setLength(0);",
				breaks: "the plant can be shifted out of sight",
			},
			{
				id: "turntable-jumps-in-the-hand",
				find: "held ? this.controls.enabled &&",
				replace: "held ?",
				breaks: "the view moves away under a drag",
			},
			{
				id: "turntable-paper-through-the-plant",
				find: "return this.distance + 1.2 *",
				replace: "return this.distance + 0 *",
				breaks: "the paper's shadow cuts through the plant",
			},
		],
	},
	{
		file: `${SRC}/camera_fit.ts`,
		suites: [`${TESTS}/camera_fit.test.ts`],
		faults: [
			{
				id: "camera-fit-by-height-alone",
				find: "nearness + vertical / halfHeight, nearness + horizontal / halfWidth)",
				replace: "nearness + vertical / halfHeight)",
				breaks: "wide plants are cut off on a phone",
			},
			{
				id: "camera-fit-never-again",
				find: "return hasOutgrown(shown, now) ||",
				replace: "return",
				breaks: "a plant that grows leaves the view",
			},
		],
	},
	{
		file: `${SRC}/frame_loop.ts`,
		suites: [`${TESTS}/frame_loop.test.ts`],
		faults: [
			{
				id: "frames-movement-lost",
				find: "this.#moving ||= moving;",
				replace: "this.#moving = moving;",
				breaks: "a drag stutters, drawn in full at every other frame",
			},
			{
				id: "frames-without-end",
				find: "if (goesOn) this.request(true);",
				replace: "if (goesOn || moving) this.request(true);",
				breaks: "the page draws for ever",
				hangs: true,
			},
			{
				id: "frames-stay-coarse",
				find: "if (this.#ratio.moving < this.#ratio.rest) this.request();",
				replace: "if (false) this.request();",
				breaks: "the picture stays coarse after a drag",
			},
		],
	},
	{
		file: `${SRC}/light.ts`,
		suites: [`${TESTS}/stage_light.test.ts`, `${TESTS}/light.test.ts`],
		faults: [
			{
				id: "light-shadow-lamp-reversed",
				find: "shadow: { depth: 0.42, direction: toward(-0.5, 0.3, 0.85) }",
				replace: "shadow: { depth: 0.42, direction: toward(0.5, 0.3, 0.85) }",
				breaks: "the shadow falls towards the light",
			},
			{
				id: "light-blurred-away",
				find: "const gain = integral(lobe.sharpness) / integral(combined);",
				replace: "const gain = 1;",
				breaks: "the surroundings are far too bright",
			},
		],
	},
	{
		file: `${SRC}/stage_light.ts`,
		suites: [`${TESTS}/stage_light.test.ts`],
		faults: [
			{
				id: "light-of-the-day-at-night",
				find: "this.#rig = rig;\n\t\tsetRig(this.uniforms, rig);",
				replace: "this.#rig = rig;",
				breaks: "the dark theme is lit like the light one",
			},
		],
	},
	{
		file: `${SRC}/stage.ts`,
		suites: [`${TESTS}/stage.test.ts`],
		faults: [
			{
				id: "stage-last-figure-stays",
				find: "this.#root.removeFromParent();",
				replace: "",
				breaks: "two models stand in one another",
			},
			{
				id: "stage-mark-stays",
				find: "this.#renderer.show(grown, specimen);\n\t\tthis.#marked = undefined;",
				replace: "this.#renderer.show(grown, specimen);",
				breaks: "a berry taken off cannot be pointed at again",
			},
		],
	},
	{
		file: `${SRC}/sphere_index.ts`,
		suites: [`${TESTS}/sphere_index.test.ts`],
		faults: [
			{
				id: "sphere-index-one-cell-short",
				find: "const toX = this.#cellAlong(0, x + distance);",
				replace: "const toX = this.#cellAlong(0, x);",
				breaks: "neighbours at the right are missed: too much light",
			},
		],
	},
	{
		file: `${SRC}/occlusion.ts`,
		suites: [`${TESTS}/occlusion.test.ts`],
		faults: [
			{
				id: "occlusion-small-as-large",
				find: "const most = Math.min(1, (radius / blur) ** 2);",
				replace: "const most = 1;",
				breaks: "tiny berries cast whole shadows",
			},
		],
	},
	{
		file: `${SRC}/streams.ts`,
		suites: [`${TESTS}/streams.test.ts`],
		faults: [
			{
				id: "streams-draw-the-rest",
				find: "geometry.setDrawRange(0, index.length);",
				replace: "",
				breaks: "triangles of the plant before are drawn with the new one",
			},
			{
				id: "streams-never-sent",
				find: "attribute.needsUpdate = true;",
				replace: "",
				breaks: "the view shows the first plant for ever",
			},
		],
	},
	{
		file: "web/src/plant/colour.ts",
		suites: ["tests/web/plant/colour.test.ts"],
		faults: [
			{
				id: "colour-not-decoded",
				find: "channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4",
				replace: "channel",
				breaks: "all colours are too bright",
			},
		],
	},
	{
		file: "web/src/plant/noise.ts",
		suites: ["tests/web/plant/noise.test.ts"],
		faults: [
			{
				id: "noise-in-blocks",
				find: "return t * t * (3 - 2 * t);",
				replace: "return 0;",
				breaks: "berries of files are mottled in cubes",
			},
		],
	},
	{
		file: "web/src/plant/part.ts",
		suites: ["tests/web/plant/parts_of.test.ts", "tests/web/models/bunch/parts/glb.test.ts"],
		faults: [
			{
				id: "parts-indices-of-the-whole",
				find: "counted[i] = indices[i] - first;",
				replace: "counted[i] = indices[i];",
				breaks: "all but the first part of a mesh are drawn with vertices that are not theirs",
			},
			{
				id: "parts-indices-copied",
				find: "if (first === 0) return indices;",
				replace: "",
				breaks: "a plant of a million lines is copied at every step of a drag",
			},
		],
	},
	{
		file: "web/src/render/shell_renderer.ts",
		suites: ["tests/web/render/shell_renderer.test.ts"],
		faults: [
			{
				id: "shell-edges-looked-for-again",
				find: "if (before) return before;",
				replace: "",
				breaks: "each step of an area's drag looks for the edges of all areas, 20 ms of the page's thread",
			},
		],
	},
	{
		file: "web/src/render/output_shader.ts",
		suites: ["tests/web/render/output_shader.test.ts"],
		faults: [
			{
				id: "berries-of-another-curve",
				find: "sRGBTransferOETF(vec4(max(vec3(0.0), toned), 1.0)).rgb",
				replace: "sqrt(max(vec3(0.0), toned))",
				breaks: "berries are darker than stems in the same light",
			},
		],
	},
	{
		file: "web/src/plant/material.ts",
		suites: ["tests/web/plant/material.test.ts"],
		faults: [
			{
				id: "materials-of-every-object",
				find: "if (Object.hasOwn(STANDARD, kind)) return",
				replace: "if (STANDARD[kind]) return",
				breaks: "a module called constructor is drawn in no colour",
			},
		],
	},
];
