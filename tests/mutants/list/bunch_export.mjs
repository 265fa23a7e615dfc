/** A bunch in files: parts, colours, tables. */
const SRC = "web/src/models/bunch";
const TESTS = "tests/web/models/bunch";

export default [
	{
		file: `${SRC}/tables.ts`,
		suites: [`${TESTS}/tables.test.ts`],
		faults: [
			{
				id: "csv-direction-y-is-x",
				find: "directionCell(grown, i, 1)",
				replace: "directionCell(grown, i, 0)",
				breaks: "the CSV's direction_y is direction_x",
			},
			{
				id: "csv-length-is-width",
				find: '["length_mm", ({ berries }, i) => millimetres(traitOf(berries, i, "length"))]',
				replace: '["length_mm", ({ berries }, i) => millimetres(traitOf(berries, i, "width"))]',
				breaks: "the CSV says that fingers are balls",
			},
			{
				id: "csv-in-metres",
				find: "return rounded(MM * metres, MM_DECIMALS);",
				replace: "return rounded(metres, MM_DECIMALS);",
				breaks: "the CSV's millimetres are metres",
			},
		],
	},
	{
		file: `${SRC}/record.ts`,
		suites: ["tests/web/formats/json.test.ts"],
		faults: [
			{
				id: "json-radius-of-the-other-end",
				find: "radiusEnd: floats(radii, 2, 1),",
				replace: "radiusEnd: floats(radii, 2, 0),",
				breaks: "the JSON's stems do not taper",
			},
			{
				id: "json-flowers-as-berries",
				find: "traits[TRAITS.length * index + set] > 0 ? 1 : 0",
				replace: "1",
				breaks: "the JSON calls flowers berries",
			},
		],
	},
	{
		file: `${SRC}/parts/stem_colour.ts`,
		suites: [`${TESTS}/parts/stem_colour.test.ts`],
		faults: [
			{
				id: "stem-nodes-ring-stout-stalks",
				find: "const nodes = slender * node.share",
				replace: "const nodes = node.share",
				breaks: "a stout stalk has a brown ring at each of its crowded nodes",
			},
			{
				id: "files-withered-as-green",
				find: "withered * dry + woody",
				replace: "woody",
				breaks: "withered stems are green in files",
			},
		],
	},
	{
		file: `${SRC}/parts/berries.ts`,
		suites: [`${TESTS}/parts/glb_natural.test.ts`, `${TESTS}/parts/glb.test.ts`, `${TESTS}/parts/flowers.test.ts`],
		faults: [
			{
				id: "flowers-of-files-without-size",
				find: "transforms.slice(at, at + TRANSFORM)",
				replace: "[...transforms.slice(at, at + TRANSFORM - 1), 1]",
				breaks: "flowers of files are a metre wide",
			},
			{
				id: "berries-of-one-size",
				find: "turn.w, scale * radius]",
				replace: "turn.w, scale]",
				breaks: "berries of files are a metre wide",
			},
			{
				id: "berries-all-alike",
				find: "const [first, last] = [(index * 3 * uvs.length) / 2, ((index + 1) * 3 * uvs.length) / 2];",
				replace: "const [first, last] = [0, (3 * uvs.length) / 2];",
				breaks: "all berries of a file are the first one",
			},
		],
	},
	{
		file: `${SRC}/parts/flowers.ts`,
		suites: [`${TESTS}/parts/flowers.test.ts`],
		faults: [
			{
				id: "stamens-on-berries",
				find: "const out = opened * (1 - set);",
				replace: "const out = opened;",
				breaks: "ripe berries wear stamens",
			},
			{
				id: "flowers-without-company",
				find: "Math.floor(extra / flowers + hashFraction(berries.ids[berry], STREAM.count))",
				replace: "0",
				breaks: "an inflorescence has no more flowers than pedicels",
			},
			{
				id: "flowers-of-the-fallen-forgotten",
				find: "const flowers = berries.count + fallen;",
				replace: "const flowers = berries.count;",
				breaks: "as flowers fall, more of them stand about those that are left",
			},
			{
				id: "caps-never-shed",
				find: "if (clings ? set > CAP.gone : opened > CAP.off) return;",
				replace: "",
				breaks: "open flowers keep their caps",
			},
			{
				id: "calyx-on-the-ovary",
				find: 'put("calyx", seat, heading, unit);',
				replace: 'put("calyx", centre, heading, unit);',
				breaks: "a bramble's sepals are inside of it",
			},
		],
	},
	{
		file: `${SRC}/parts/berry_tint.ts`,
		suites: [`${TESTS}/parts/berry_tint.test.ts`],
		faults: [
			{
				id: "tint-all-in-half-shade",
				find: 'procedure === "paper" ? HALF : traitOf(berries, index, "exposure")',
				replace: "HALF",
				breaks: "the sun colours no berry, in view and files",
			},
			{
				id: "tint-nobody-late",
				find: "const late = 2 * skin.uneven * smoothstep(0.86, 1, hashFraction(id, 3));",
				replace: "const late = 0;",
				breaks: "no berry ripens late",
			},
			{
				id: "tint-raisins-as-ripe",
				find: "return mixed(colour, raisin, 0.93 * smoothstep(0, 0.8, shrivel));",
				replace: "return colour;",
				breaks: "raisins keep the colour of grapes",
			},
			{
				id: "tint-pale-raisins-as-dark-ones",
				find: "hue: 0.8 + 0.25 * pale,",
				replace: "hue: 0.8,",
				breaks: "raisins of pale grapes are the brown of dark ones",
			},
			{
				id: "tint-sun-on-the-shade",
				find: "const sunned = 2 * skin.uneven * (exposure - 0.5);",
				replace: "const sunned = 2 * skin.uneven * (0.5 - exposure);",
				breaks: "shaded berries are golden",
			},
		],
	},
	{
		file: `${SRC}/parts/berry_colour.ts`,
		suites: [`${TESTS}/parts/berry_colour.test.ts`, `${TESTS}/parts/look.test.ts`],
		faults: [
			{
				id: "colour-no-sun",
				find: 'const gilded = skin.sunned.amber * traitOf(berries, index, "exposure");',
				replace: "const gilded = 0;",
				breaks: "pale berries of files are no more amber in the sun",
			},
			{
				id: "colour-grey-among-clear-berries",
				find: "visible < 1 ? colour * neighbourLight(colour, k, clear, visible) : colour",
				replace: "colour",
				breaks: "the inside of pale bunches is dull in files, and warm in the view",
			},
			{
				id: "colour-green-flesh-in-raisins",
				find: "value * Math.exp(-BROWNED[k] * shrivel)",
				replace: "value",
				breaks: "raisins of files are greener than those of the view",
			},
			{
				id: "files-all-wax-on-the-face",
				find: "hiddenBy(WAX_ON_FACE * waxDepth(",
				replace: "hiddenBy(waxDepth(",
				breaks: "dark skins of files are grey in light from all sides",
			},
			{
				id: "files-light-where-berries-press",
				find: "(1 - CREVICE.pressed * rubbed)",
				replace: "1",
				breaks: "between berries that touch it is as light as on their faces",
			},
			{
				id: "files-raisins-of-flesh",
				find: "FLESH_ON_FACE * set * (1 - shrivel)",
				replace: "FLESH_ON_FACE * set",
				breaks: "pale raisins have the colour of fresh flesh",
			},
			{
				id: "files-without-a-scar",
				find: "return smoothstep(scar - SCAR_EDGE, scar, v);",
				replace: "return 0;",
				breaks: "berries of files have no scar at their tip",
			},
			{
				id: "files-turn-from-the-seat",
				find: "0.5 - TURNING.along * along",
				replace: "0.5 + TURNING.along * along",
				breaks: "berries of files turn at the wrong end",
			},
		],
	},
	{
		file: "web/src/formats/alike.ts",
		suites: [`${TESTS}/parts/instances.test.ts`],
		faults: [
			{
				id: "alike-of-one-shade",
				find: "Math.min(SHADES - 1, Math.floor(SHADES * skyShareOf(shape.mesh)))",
				replace: "0",
				breaks: "instances are as light inside a bunch as outside",
			},
			{
				id: "alike-turned-twice",
				find: "rotationMatrix({ x: -qx, y: -qy, z: -qz, w: qw })",
				replace: "rotationMatrix({ x: qx, y: qy, z: qz, w: qw })",
				breaks: "instances point anywhere but where their berries do",
			},
			{
				id: "alike-as-large-as-the-first",
				find: "inverseRotation, 1 / size, ORIGIN",
				replace: "inverseRotation, 1, ORIGIN",
				breaks: "instances are specks",
			},
			{
				id: "alike-without-flowers",
				find: "...others, ...joinInstances(attached)]",
				replace: "...others]",
				breaks: "a flowering bunch of instances has no stamens",
			},
		],
	},
	{
		file: `${SRC}/parts/skin_rules.ts`,
		suites: [`${TESTS}/parts/berry_colour.test.ts`],
		faults: [
			{
				id: "wax-half-as-deep",
				find: "\tdepth: 1.2,",
				replace: "\tdepth: 0.6,",
				breaks: "bloom is half as thick, in view and files",
			},
		],
	},
	{
		file: `${SRC}/parts/skin.ts`,
		suites: [`${TESTS}/parts/skin.test.ts`],
		faults: [
			{
				id: "skin-dark-as-pale",
				find: "const density = mix(1.1, 0.42, pale) + 1.9 * dark;",
				replace: "const density = mix(1.1, 0.42, pale);",
				breaks: "black grapes glow like white ones",
			},
		],
	},
	{
		file: `${SRC}/parts/materials.ts`,
		suites: [`${TESTS}/parts/materials.test.ts`],
		faults: [
			{
				id: "materials-leaves-one-sided",
				find: "specular: 0.6,\n\t\t\tdoubleSided: true,",
				replace: "specular: 0.6,",
				breaks: "leaves vanish from below in other programs",
			},
			{
				id: "materials-bloom-dull-nothing",
				find: "roughness: mix(clean, bloomed, look.bloom),",
				replace: "roughness: clean,",
				breaks: "bloomed berries of files shine as polished",
			},
		],
	},
	{
		file: "web/src/formats/light.ts",
		suites: ["tests/web/formats/light_glb.test.ts"],
		faults: [
			{
				id: "low-berries-never-merged",
				find: "if (bestAgreement >= SAME_OUTLINE) break;",
				replace: "break;",
				breaks: "a bunch of 500 triangles is shards of its berries",
			},
		],
	},
	{
		file: "web/src/formats/merged_bodies.ts",
		suites: ["tests/web/formats/light_glb.test.ts"],
		faults: [
			{
				id: "merged-open-meshes",
				find: "radiusOf(mesh) >= leastRadius && isClosed(mesh)",
				replace: "radiusOf(mesh) >= leastRadius",
				breaks: "a sheet beside berries is merged with them, though it holds nothing",
			},
			{
				id: "merged-colours-of-one",
				find: "colours[at + k] = known[3 * nearest + k]",
				replace: "colours[at + k] = known[k]",
				breaks: "all berries of a merged body have the colour of the first",
			},
		],
	},
	{
		file: "web/src/formats/point_tree.ts",
		suites: ["tests/web/formats/point_tree.test.ts"],
		faults: [
			{
				id: "point-tree-one-side",
				find: "if (beyond ** 2 >= this.#least) return;",
				replace: "return;",
				breaks: "a merged body takes colours from vertices that are not the nearest",
			},
		],
	},
];
