/** How a bed looks and is handled: its stems, its ground, its map and the plant that is chosen. */
const WEB = "tests/web/models/stand";

export default [
	{
		file: "web/src/models/stand/tools/map_colours.ts",
		suites: [`${WEB}/map_colours.test.ts`],
		faults: [
			{
				id: "stand-map-shows-leaves",
				find: "const told = flowers.length > 0 ? flowers : (most ?? []);",
				replace: "const told = most ?? flowers;",
				breaks: "on the map poppies are as green as grass",
			},
			{
				id: "stand-map-sorts-alike",
				find: "if (free(toLch(fromLch(tried)))) return tried;",
				replace: "if (free(wanted) || true) return wanted;",
				breaks: "two yellow flowers are one on the map",
			},
			{
				id: "stand-map-hue-first",
				find: "for (const more of eitherWay(STEP, LIGHTEST - LIGHT)) {",
				replace: "for (const more of [0, STEP]) {",
				breaks: "a globeflower is as green as grass on the map, beside a buttercup",
			},
		],
	},
	{
		file: "web/src/models/stand/figure/mark_ring.ts",
		suites: [`${WEB}/mark_ring.test.ts`],
		faults: [
			{
				id: "stand-ring-as-wide-as-near",
				find: "const r = radius + off * WIDE * seen;",
				replace: "const r = radius + off * WIDE;",
				breaks: "the ring about a chosen plant is too thin to see from afar",
			},
			{
				id: "stand-ring-in-the-slope",
				find: "const y = stands ? heightAt(stand, x, z) : this.#at.y;",
				replace: "const y = stands || heightAt(stand, x, z) ? this.#at.y : 0;",
				breaks: "the ring about a chosen plant is half in the ground of a slope",
			},
			{
				id: "stand-ring-under-what-hangs",
				find: "const stands = places.bearer[this.#plant] < 0;",
				replace: "const stands = places.count > 0;",
				breaks: "the ring about a chosen bunch lies under its vine",
			},
			{
				id: "stand-ring-of-no-size",
				find: "Math.max(ABOUT * crown, LEAST * seen)",
				replace: "Math.max(ABOUT * crown, 0 * LEAST)",
				breaks: "nobody sees the ring about a small plant from afar",
			},
			{
				id: "stand-ring-stays-behind",
				find: "if (stand !== this.#stand || plant !== this.#plant) this.#laid = false;",
				replace: "",
				breaks: "the ring stays about the plant that was chosen before",
			},
			{
				id: "stand-ring-laid-in-each-frame",
				find: "this.#laid = true;",
				replace: "",
				breaks: "every frame of a view at rest looks up 432 heights",
			},
		],
	},
	{
		file: "web/src/models/stand/tools/map.ts",
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
				find: "y - FALL * far * share,",
				replace: "y,",
				breaks: "the ground ends like a cloth",
			},
			{
				id: "stand-rim-has-a-gap",
				find: "for (let brink = 0; brink < brinks.length; brink++) {",
				replace: "for (let brink = 1; brink < brinks.length; brink++) {",
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
				find: "Math.round(all(mesh.sky, 1)[0])",
				replace: "all(mesh.sky, 1)[0]",
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
		file: "web/src/models/stand/figure/brims.ts",
		suites: [`${WEB}/brims.test.ts`],
		faults: [
			{
				id: "stand-thin-stems-made-longer",
				find: "ways[at + 1] += y - along * way[1];",
				replace: "ways[at + 1] += y;",
				breaks: "stems thinner than a pixel are made longer, and stay rows of dashes",
			},
		],
	},
];
