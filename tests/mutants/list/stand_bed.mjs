/** How a bed looks and is handled: its stems, its ground, its map and the plant that is chosen. */
const WEB = "tests/web/models/stand";

export default [
	{
		file: "web/src/models/stand/ui/map_colours.ts",
		suites: [`${WEB}/map_colours.test.ts`],
		faults: [
			{
				id: "stand-map-shows-leaves",
				find: "const meshes = flowers.length > 0 ? flowers : (largest ?? []);",
				replace: "const meshes = largest ?? flowers;",
				breaks: "on the map poppies are as green as grass",
			},
			{
				id: "stand-map-dark-plants",
				find: "separateColours(ownColours, PLANT_LIGHTNESS)",
				replace: "separateColours(ownColours, [0, PLANT_LIGHTNESS[1]])",
				breaks: "a dark plant is lost on the map's ground",
			},
		],
	},
	{
		file: "web/src/models/stand/ui/separate_colours.ts",
		suites: [`${WEB}/separate_colours.test.ts`],
		faults: [
			{
				id: "stand-map-sorts-alike",
				find: "if (isFree(candidate)) return candidate;",
				replace: "if (isFree(candidate) || true) return candidate;",
				breaks: "two yellow flowers are one on the map",
			},
			{
				id: "stand-map-hue-first",
				find: "for (const lightnessShift of shiftsUpTo(LIGHTNESS_STEP, most - least)) {",
				replace: "for (const lightnessShift of [0, LIGHTNESS_STEP]) {",
				breaks: "a globeflower is as green as grass on the map, beside a buttercup",
			},
			{
				id: "stand-map-lighter-only",
				find: "[step * (i + 1), -step * (i + 1)]",
				replace: "[step * (i + 1)]",
				breaks: "the second of two white flowers is salmon on the map",
			},
			{
				id: "stand-map-apart-as-asked",
				find: "toLch(fromLch(lch))",
				replace: "lch",
				breaks: "two yellow flowers that no screen can tell apart are taken for two",
			},
		],
	},
	{
		file: "web/src/models/stand/render/mark_ring.ts",
		suites: [`${WEB}/mark_ring.test.ts`],
		faults: [
			{
				id: "stand-ring-as-wide-as-near",
				find: "const r = radius + offset * HALF_WIDTH * viewHeight;",
				replace: "const r = radius + offset * HALF_WIDTH;",
				breaks: "the ring about a chosen plant is too thin to see from afar",
			},
			{
				id: "stand-ring-in-the-slope",
				find: "const y = isOnGround ? heightAt(stand, x, z) : this.#at.y;",
				replace: "const y = isOnGround || heightAt(stand, x, z) ? this.#at.y : 0;",
				breaks: "the ring about a chosen plant is half in the ground of a slope",
			},
			{
				id: "stand-ring-under-what-hangs",
				find: "const isOnGround = places.parent[this.#plant] < 0;",
				replace: "const isOnGround = places.count > 0;",
				breaks: "the ring about a chosen bunch lies under its vine",
			},
			{
				id: "stand-ring-of-no-size",
				find: "Math.max(CROWN_SHARE * crown, LEAST_RADIUS * viewHeight)",
				replace: "Math.max(CROWN_SHARE * crown, 0 * LEAST_RADIUS)",
				breaks: "nobody sees the ring about a small plant from afar",
			},
			{
				id: "stand-ring-stays-behind",
				find: "if (stand !== this.#stand || plant !== this.#plant) this.#isBuilt = false;",
				replace: "",
				breaks: "the ring stays about the plant that was chosen before",
			},
			{
				id: "stand-ring-laid-in-each-frame",
				find: "this.#isBuilt = true;",
				replace: "",
				breaks: "every frame of a view at rest looks up 432 heights",
			},
		],
	},
	{
		file: "web/src/models/stand/render/ground_renderer.ts",
		suites: [`${WEB}/ground_renderer.test.ts`],
		faults: [
			{
				id: "stand-ground-built-anew",
				find: "this.#material ??= groundMaterial(",
				replace: "this.#material?.dispose();\n\t\tthis.#material = fading(",
				breaks: "the ground's program is built anew at each step of its colour's dragging",
			},
			{
				id: "stand-ground-patches-stay",
				find: "this.#patches.value = PATCHES / shorterSide;",
				replace: "if (this.#patches.value === 1) this.#patches.value = PATCHES / shorterSide;",
				breaks: "a small ground after a large one fades evenly all round",
			},
			{
				id: "stand-ground-colour-stays",
				find: "else this.#material.color.fromArray(material.colour);",
				replace: "",
				breaks: "a ground without mottles keeps the colour that it had first",
			},
			{
				id: "stand-ground-ends-at-an-edge",
				find: "* (1.0 - smoothstep(0.7, 1.0, rimShare))",
				replace: "",
				breaks: "here and there the ground does not fade into the paper, but ends",
			},
		],
	},
	{
		file: "web/src/models/stand/render/stand_renderer.ts",
		suites: [`${WEB}/stand_renderer.test.ts`],
		faults: [
			{
				id: "stand-stays-bright-without-a-ring",
				find: "		this.mark(undefined);\n",
				replace: "		this.#ring.show(undefined, undefined);\n",
				breaks: "a plant that was pointed at stays bright for good when others come",
			},
		],
	},
	{
		file: "web/src/models/stand/render/crowd_material.ts",
		suites: [`${WEB}/crowd_material.test.ts`],
		faults: [
			{
				id: "stand-stems-are-too-thin",
				find: "0.5 * lacking / metre *",
				replace: "0.05 * lacking / metre *",
				breaks: "stems from afar are rows of dashes",
			},
			{
				id: "stand-twigs-hide-leaves",
				find: "const WIDEST = 4;",
				replace: "const WIDEST = 400;",
				breaks: "a far wood is all twigs",
			},
			{
				id: "stand-ribbons-are-too-thin",
				find: "vec3 out_ = normal + edgeNormal.xyz * (1.0 - max(0.0, dot(normal, edgeNormal.xyz)));",
				replace: "vec3 out_ = normal;",
				breaks: "far blades of grass are rows of dashes",
			},
			{
				id: "stand-widened-as-if-unscaled",
				find: "edgeNormal.w * edgeNormal.w * length(batchingMatrix[0].xyz) * metre",
				replace: "edgeNormal.w * edgeNormal.w * metre",
				breaks: "stems of small plants are dashes, those of large ones clubs",
			},
		],
	},
	{
		file: "web/src/models/stand/ui/map.ts",
		suites: [`${WEB}/map.test.ts`],
		faults: [
			{
				id: "stand-escape-takes-fields",
				find: 'return !field || field.closest(".stand-plant") !== null;',
				replace: "void field;\n\treturn true;",
				breaks: "who leaves a field by Escape loses the chosen plant",
			},
		],
	},
	{
		file: "web/src/models/stand/rim.ts",
		suites: [`${WEB}/soil.test.ts`],
		faults: [
			{
				id: "stand-rim-is-level",
				find: "y - FALL * distance * share,",
				replace: "y,",
				breaks: "the ground ends like a cloth",
			},
			{
				id: "stand-rim-has-a-gap",
				find: "for (let column = 0; column < edge.length; column++) {",
				replace: "for (let column = 1; column < edge.length; column++) {",
				breaks: "the ground's rim is open at a corner",
			},
		],
	},
	{
		file: "web/src/models/stand/finer_ground.ts",
		suites: [`${WEB}/finer_ground.test.ts`],
		faults: [
			{
				id: "stand-ground-sky-cut-down",
				find: "Math.round(interpolated(mesh.sky, 1)[0])",
				replace: "interpolated(mesh.sky, 1)[0]",
				breaks: "the ground is darker between the core's places than at them",
			},
		],
	},
	{
		file: "web/src/models/stand/ground_grid.ts",
		suites: [`${WEB}/ground_grid.test.ts`],
		faults: [
			{
				id: "stand-ground-ends-beyond-itself",
				find: "clamp(value / size + 0.5) * cells",
				replace: "(0 * clamp(0) + value / size + 0.5) * cells",
				breaks: "who looks from beside a ground is at no height at all",
			},
		],
	},
	{
		file: "web/src/models/stand/render/edge_normals.ts",
		suites: [`${WEB}/edge_normals.test.ts`],
		faults: [
			{
				id: "stand-thin-stems-made-longer",
				find: "vectors[at + 1] += y - component * direction[1];",
				replace: "vectors[at + 1] += y;",
				breaks: "stems thinner than a pixel are made longer, and stay rows of dashes",
			},
			{
				id: "stand-edge-normals-found-again",
				find: "cache.get(mesh) ?? computeEdgeNormals(mesh)",
				replace: "computeEdgeNormals(mesh)",
				breaks: "who walks through many plants halts as each comes near, also for the tenth time",
			},
		],
	},
	{
		file: "web/src/models/stand/stand_plant.ts",
		suites: [`${WEB}/fetched_soil.test.ts`],
		faults: [
			{
				id: "stand-bare-without-a-word",
				find: 'mesh && !soil ? [...plant.notes, text("no_soil")] : plant.notes',
				replace: "plant.notes",
				breaks: "where part of the page did not come, the same link has another ground, and nothing says so",
			},
		],
	},
];
