/** Textures of leaves, from their pixels to view and files. */
const PARTS = "web/src/models/leaf/parts";
const TESTS = "tests/web/models/leaf";

export default [
	{
		file: `${PARTS}/face_pictures.ts`,
		suites: [`${TESTS}/bake.test.ts`, `${TESTS}/face_pictures.test.ts`],
		faults: [
			{
				id: "leaf-normals-green-down",
				find: "const ny = -slopeFactor * up;",
				replace: "const ny = slopeFactor * up;",
				breaks: "light from above shows veins as if it came from below",
			},
			{
				id: "leaf-normals-not-mirrored",
				find: "const nx = -sign * slopeFactor * right;",
				replace: "const nx = -slopeFactor * right;",
				breaks: "light from the left shows the lower face's veins as if it came from the right",
			},
		],
	},
	{
		file: `${PARTS}/vein_raster.ts`,
		suites: [`${TESTS}/face_pictures.test.ts`],
		faults: [
			{
				id: "leaf-veins-alike-whatever-passes",
				find: "radius, opacityOf(energy[piece], range));",
				replace: "radius, 1);",
				breaks: "the finest veins are as bright as the midrib",
			},
		],
	},
	{
		file: `${PARTS}/blade_fields.ts`,
		suites: [`${TESTS}/face_pictures.test.ts`],
		faults: [
			{
				id: "leaf-fed-alike-by-all-veins",
				find: "REACH * side * relativeWidth ** REACH_POWER",
				replace: "REACH * side",
				breaks: "in autumn green bands are as broad about a twig of a vein as about the midrib",
			},
		],
	},
	{
		file: `${PARTS}/as_seen.ts`,
		suites: [`${TESTS}/leaf.test.ts`],
		faults: [
			{
				id: "leaf-pictures-mirrored",
				find: "at % 2 === 0 && side",
				replace: "side",
				breaks: "pictures lie head down, and readers' tangents are of the other hand",
			},
		],
	},
	{
		file: "web/src/render/material_cache.ts",
		suites: ["tests/web/render/part_renderer.test.ts"],
		faults: [
			{
				id: "wardrobe-keeps-first-pictures",
				find: "if (shows[kind] === picture) return;",
				replace: "if (shows[kind]) return;",
				breaks: "a leaf dragged to another shape keeps the veins of the first",
			},
		],
	},
	{
		file: "web/src/formats/vertex_colours.ts",
		suites: ["tests/web/formats/glb_textures.test.ts"],
		faults: [
			{
				id: "glb-picture-coloured-twice",
				find: "return textures?.colour ? [1, 1, 1] : colour;",
				replace: "return colour;",
				breaks: "pictures are dyed once more by the material's colour",
			},
		],
	},
];
