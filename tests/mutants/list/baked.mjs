/** Textures baked from vertex data and finer detail, and their sources. */
const SRC = "web/src/formats";
const TESTS = "tests/web/formats";
const BUNCH = "web/src/models/bunch/parts";
const BUNCH_TESTS = "tests/web/models/bunch/parts";

export default [
	{
		file: `${SRC}/atlas.ts`,
		suites: [`${TESTS}/baked.test.ts`],
		faults: [
			{
				id: "baked-black-at-the-seams",
				find: "this.#spread(drawn, tile);",
				replace: "",
				breaks: "berries with textures have a black line from seat to tip",
			},
			{
				id: "baked-all-on-one-tile",
				find: "return { left: (tile % this.#columns) * this.#tile,",
				replace: "return { left: 0,",
				breaks: "berries with textures wear each other's colours",
			},
			{
				id: "baked-beyond-what-there-is",
				find: "weights.map((weight) => Math.max(0, weight))",
				replace: "weights",
				breaks: "what is fully lit is black at the edges of triangles",
			},
		],
	},
	{
		file: `${SRC}/baked.ts`,
		suites: [`${TESTS}/baked.test.ts`],
		faults: [
			{
				id: "baked-without-shade",
				find: "surface: [open ? byte(among(open, 1, 0)) : 255,",
				replace: "surface: [255,",
				breaks: "a bunch with textures is as light inside as outside",
			},
			{
				id: "baked-as-rough-everywhere",
				find: "detail?.at(corners, weights) ?? {",
				replace: "{",
				breaks: "wax lies on berries with textures and does not show in their mirror",
			},
			{
				id: "baked-relief-inside-out",
				find: "const side = among(tangents, 4, 3) < 0 ? -1 : 1;",
				replace: "const side = among(tangents, 4, 3) < 0 ? 1 : -1;",
				breaks: "bumps of a baked rind are hollows from above",
			},
			{
				id: "baked-where-pictures-repeat",
				find: "return uvs.every((value) => value >= 0 && value <= 1);",
				replace: "return true;",
				breaks: "stems with textures show the colours of berries",
			},
		],
	},
	{
		file: `${SRC}/gltf_material.ts`,
		suites: [`${TESTS}/baked.test.ts`],
		faults: [
			{
				id: "baked-roughness-twice",
				find: "textures.surface === undefined ? shortNumber(roughness) : 1",
				replace: "shortNumber(roughness)",
				breaks: "berries with textures are as smooth as glass",
			},
		],
	},
	{
		file: `${SRC}/gltf_material.ts`,
		suites: [`${TESTS}/glb_textures.test.ts`],
		faults: [
			{
				id: "diffuse-brighter-than-light",
				find: "shortNumber(greatest / (1 + greatest))",
				replace: "shortNumber(greatest)",
				breaks: "leaves and petals of files let more light through than the view shows",
			},
			{
				id: "diffuse-lit-twice",
				find: "flesh ? undefined : diffuseTransmission(material, textures)",
				replace: "diffuseTransmission(material, textures)",
				breaks: "light comes twice through a baked leaf",
			},
		],
	},
	{
		file: `${BUNCH}/berry_finer.ts`,
		suites: [`${BUNCH_TESTS}/berry_finer.test.ts`],
		faults: [
			{
				id: "finer-wax-as-smooth",
				find: "mix(SKIN_ROUGHNESS[0], WAXED_ROUGHNESS, waxed)",
				replace: "SKIN_ROUGHNESS[0]",
				breaks: "a bunch in full bloom shines as if it were washed, with textures",
			},
			{
				id: "finer-relief-of-all",
				find: "const relief = steep > FURROWS.least;",
				replace: "const relief = true;",
				breaks: "a picture of normals that are flat is in every file with textures",
			},
			{
				id: "finer-no-relief",
				find: "value - steep * (slope[k] - value * out)",
				replace: "value",
				breaks: "a lychee with textures is as smooth as a grape",
			},
		],
	},
	{
		file: `${BUNCH}/wax.ts`,
		suites: [`${BUNCH_TESTS}/berry_colour.test.ts`, `${BUNCH_TESTS}/look.test.ts`],
		faults: [
			{
				id: "files-without-wax",
				find: "return WAX.depth * bloom *",
				replace: "return 0 * bloom *",
				breaks: "berries of files have no bloom",
			},
			{
				id: "files-wax-not-rubbed-off",
				find: "(1 - touched) *",
				replace: "1 *",
				breaks: "wax lies where berries touch",
			},
		],
	},
	{
		file: `${SRC}/palette.ts`,
		suites: [`${TESTS}/usdz.test.ts`],
		faults: [
			{
				id: "palette-second-axis-of-a-line",
				find: "traceOf(remaining) > LEAST_SPREAD * totalSpread ?",
				replace: "totalSpread >= 0 ?",
				breaks: "what has shades of one colour is brighter where it is bright and darker where it is dark",
			},
			{
				id: "palette-over-a-picture",
				find: "|| material.textures?.colour) return shape;",
				replace: ") return shape;",
				breaks: "leaves of the low form lose their veins",
			},
		],
	},
	{
		file: `${SRC}/low_glb.ts`,
		suites: [`${TESTS}/usdz.test.ts`],
		faults: [
			{
				id: "low-by-vertices-alone",
				find: "exportGlb(paletted(await lightParts(parts, { triangles, pixels: PIXELS, plant })), about)",
				replace: "exportGlb(await lightParts(parts, { triangles, pixels: PIXELS, plant }), about)",
				breaks: "the low form is grey in F3D and in engines that leave colours of vertices out",
			},
		],
	},
	{
		file: `${SRC}/solid.ts`,
		suites: [`${TESTS}/solid.test.ts`],
		faults: [
			{
				id: "print-torn-edges-unseen",
				find: "count(from, to) !== 1 || count(to, from) !== 1",
				replace: "count(from, to) !== 1",
				breaks: "a body with a hole in it is taken for closed",
			},
		],
	},
	{
		file: "wasm-core/tools/toolchain.mjs",
		suites: ["tests/tools/toolchain.test.ts"],
		faults: [
			{
				id: "toolchain-any-python",
				find: 'python && capture(python, ["-c", "import ensurepip, venv"], env) !== null ? python : null',
				replace: "python",
				breaks: "on a fresh Debian `npm test` fails in the middle, where trimesh is to be installed",
			},
		],
	},
];
