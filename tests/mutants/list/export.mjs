/** File formats common to all plants, and reading them. */
const SRC = "web/src/formats";
const TESTS = "tests/web/formats";

export default [
	{
		file: `${SRC}/restore.ts`,
		suites: [`${TESTS}/restore.test.ts`],
		faults: [
			{
				id: "file-truncated-glb-taken",
				find: "if (header.getUint32(8, true) > file.size || type !== CHUNK_JSON || length > file.size - start) throw broken;",
				replace: "if (type !== CHUNK_JSON) throw broken;",
				breaks: "half a download is said to be no file of ours",
			},
			{
				id: "file-of-any-size-read",
				find: "if (read.size > JSON_BYTES)",
				replace: "if (read.size < 0)",
				breaks: "a dropped film fills the memory",
			},
			{
				id: "file-of-a-list-taken",
				find: "return isRecord(specimen) ? specimen : undefined;",
				replace: "return specimen as object;",
				breaks: "a file with a list in the specimen's place opens the default bunch without a word",
			},
		],
	},
	{
		file: `${SRC}/obj.ts`,
		suites: [`${TESTS}/obj.test.ts`],
		faults: [
			{
				id: "obj-plain-colour-in-no-picture",
				find: '(kind === "colour" ? onePixel(material.colour).picture : undefined)',
				replace: "undefined",
				breaks: "Blender shows every material of an OBJ too pale",
			},
			{
				id: "obj-petals-of-one-colour",
				find: "const seen = shape && (shown.get(shape) ?? shape);",
				replace: "const seen = shape;",
				breaks: "petals of an OBJ are of one colour from foot to tip",
			},
			{
				id: "obj-pictures-that-are-not-there",
				find: ".map((each) => (pictured ?",
				replace: ".map((each) => (pictured || true ?",
				breaks: "plants out of a bare address's OBJ are white",
			},
		],
	},
	{
		file: `${SRC}/mtl.ts`,
		suites: [`${TESTS}/obj.test.ts`],
		faults: [
			{
				id: "mtl-highlights-as-wide-as-can-be",
				find: "rounded(2 / roughness ** 4 - 2, 1)",
				replace: "rounded(2 / roughness ** 2 - 2, 1)",
				breaks: "berries from an OBJ look like felt",
			},
			{
				id: "mtl-linear-colours",
				find: "encoded(colour).map(short)",
				replace: "colour.map(short)",
				breaks: "berries from an OBJ are too dark",
			},
		],
	},
	{
		file: `${SRC}/obj_writer.ts`,
		suites: [`${TESTS}/obj.test.ts`],
		faults: [
			{
				id: "obj-texture-upside-down",
				find: "out.fixed(1 - uvs[i + 1], SHADE_DECIMALS, LINE_END);",
				replace: "out.fixed(uvs[i + 1], SHADE_DECIMALS, LINE_END);",
				breaks: "pictures lie upside down on an OBJ's berries",
			},
			{
				id: "obj-every-object-from-one",
				find: "this.#vertices += positions.length / 3;",
				replace: "",
				breaks: "all objects of an OBJ are drawn with the first one's vertices",
			},
		],
	},
	{
		file: `${SRC}/glb.ts`,
		suites: [`${TESTS}/glb.test.ts`],
		faults: [
			{
				id: "glb-base-in-no-picture",
				find: "if (!document.compact) this.#paintBases(parts);",
				replace: "",
				breaks: "F3D shows every bunch in grey",
			},
			{
				id: "glb-picture-without-a-place",
				find: "if (material.textures?.colour || this.#bare.has(material)) continue;",
				replace: "if (material.textures?.colour) continue;",
				breaks: "a picture lies on a mesh that has no texture coordinates",
			},
			{
				id: "glb-instances-unscaled",
				find: "scales.fill(transforms[first + 7] * unit,",
				replace: "scales.fill(unit,",
				breaks: "all berries of an instanced GLB are of one size",
			},
			{
				id: "glb-compact-instances-unscaled",
				find: "const size = Math.fround(rest[4] * unit);",
				replace: "const size = Math.fround(rest[4]);",
				breaks: "flowers of a compact GLB are far too large",
			},
			{
				id: "glb-children-where-their-parent-is",
				find: "held.push(...children.map((child) => this.#writePart(child, frame)));",
				replace: "held.push(...children.map((child) => this.#writePart(child, parent)));",
				breaks: "flowers hang in the air",
			},
		],
	},
	{
		file: `${SRC}/quantise.ts`,
		suites: [`${TESTS}/glb.test.ts`],
		faults: [
			{
				id: "quantise-off-centre",
				find: "Math.round((positions[i + axis] - centre[axis]) * steps)",
				replace: "Math.round(positions[i + axis] * steps)",
				breaks: "parts of a compact GLB stand in the wrong place",
			},
		],
	},
	{
		file: `${SRC}/vertex_colours.ts`,
		suites: [`${TESTS}/glb.test.ts`],
		faults: [
			{
				id: "colours-as-they-are",
				find: "value > 0 ? 255 / value : 0",
				replace: "255",
				breaks: "colours of a GLB are darkened twice",
			},
		],
	},
	{
		file: `${SRC}/growth_glb.ts`,
		suites: [`${TESTS}/growth_glb.test.ts`],
		faults: [
			{
				id: "growth-names-repeat",
				find: "const name = atAge(numbered, ages[i]);",
				replace: "const name = numbered;",
				breaks: "parts of all ages have the same names",
			},
			{
				id: "growth-material-an-age",
				find: "material: oldest.get(material.name) ?? material",
				replace: "material",
				breaks: "each age has materials of its own, with the same names",
			},
		],
	},
	{
		file: `${SRC}/animation.ts`,
		suites: [`${TESTS}/growth_glb.test.ts`],
		faults: [
			{
				id: "growth-blends",
				find: 'interpolation: "STEP"',
				replace: 'interpolation: "LINEAR"',
				breaks: "two ages of a plant stand one in the other while it grows",
			},
			{
				id: "growth-nothing-at-rest",
				find: "scale: ends ? 0 : 1 };",
				replace: "scale: 1 };",
				breaks: "programs that play nothing show all ages at once",
			},
		],
	},
	{
		file: `${SRC}/csv.ts`,
		suites: [`${TESTS}/csv.test.ts`],
		faults: [
			{
				id: "csv-quotes-not-doubled",
				find: `text.replaceAll('"', '""')`,
				replace: "text",
				breaks: "a quote in a cell breaks the table",
			},
		],
	},
	{
		file: `${SRC}/text_buffer.ts`,
		suites: [`${TESTS}/text_buffer.test.ts`],
		faults: [
			{
				id: "text-buffer-never-grows",
				find: "if (this.#length > 0) this.#chunks.push(this.#bytes.subarray(0, this.#length));",
				replace: "",
				breaks: "large OBJ files lose their beginning",
			},
			{
				id: "text-buffer-words-are-ascii",
				find: "if (code > LAST_OF_ASCII) {",
				replace: "if (code < 0) {",
				breaks: "a kind that is named in another language is garbled in the service's JSON",
			},
			{
				id: "text-buffer-short-without-sign",
				find: "if (value < 0) this.#bytes[this.#length++] = MINUS;\n\t\tconst power = EXACT_POWERS",
				replace: "const power = EXACT_POWERS",
				breaks: "in the service's JSON every bunch lies in one quarter",
			},
		],
	},
	{
		file: `${SRC}/numbers.ts`,
		suites: [`${TESTS}/text_buffer.test.ts`],
		faults: [
			{
				id: "short-float-without-exponent",
				find: "size >= LEAST_PLAIN &&",
				replace: "size > 0 &&",
				breaks: "the smallest numbers of the service's JSON are not written as everywhere else",
			},
		],
	},
	{
		file: `${SRC}/rows.ts`,
		suites: [`${TESTS}/json.test.ts`],
		faults: [
			{
				id: "rows-without-commas",
				find: 'if (index > 0) out.word(",");',
				replace: "",
				breaks: "the service's JSON cannot be read",
			},
		],
	},
	{
		file: "web/src/generate/files/zip.ts",
		suites: ["tests/web/generate/files/zip.test.ts"],
		faults: [
			{
				id: "zip-of-today",
				find: "mtime: ZIP_DATE",
				replace: "mtime: new Date()",
				breaks: "the same bunch gives another archive every day",
			},
		],
	},
	{
		file: `${SRC}/hidden.ts`,
		suites: [`${TESTS}/hidden.test.ts`],
		faults: [
			{
				id: "hidden-by-corners-alone",
				find: "hidden[a] && hidden[b] && hidden[c] &&",
				replace: "(hidden[a] || hidden[b] || hidden[c]) &&",
				breaks: "what comes out of a body loses its foot as far as one sees it",
			},
		],
	},
	{
		file: `${SRC}/sparse.ts`,
		suites: [`${TESTS}/sparse.test.ts`],
		faults: [
			{
				id: "sparse-crown-thins",
				find: "const larger = 1 / Math.sqrt(keep);",
				replace: "const larger = 1;",
				breaks: "the low form of a tree is bare",
			},
		],
	},
	{
		file: `${SRC}/solid.ts`,
		suites: [`${TESTS}/solid.test.ts`],
		faults: [
			{
				id: "print-hollow",
				find: "	fillHollows(voxels);",
				replace: "",
				breaks: "what has hollows is printed with them",
			},
			{
				id: "print-in-pieces",
				find: "joinPieces(voxels, THICK, Math.ceil(FARTHEST / pitch))",
				replace: "0",
				breaks: "what is loose is printed loose",
			},
			{
				id: "print-empty",
				find: "if (!meshes.some(({ indices }) => indices.length > 0)) throw new EmptyPlantError();",
				replace: "",
				breaks: "an empty plant is not refused as such",
			},
			{
				id: "print-thicker-unsaid",
				find: "thickness > 1.01 * least",
				replace: "thickness > 1000 * least",
				breaks: "no note says that a body is thicker than requested",
			},
		],
	},
	{
		file: `${SRC}/voxels.ts`,
		suites: [`${TESTS}/solid.test.ts`],
		faults: [
			{
				id: "print-too-thin",
				find: "cells[i] |= opened[i];",
				replace: "cells[i] = opened[i];",
				breaks: "what is thin is not printed at all",
			},
		],
	},
];
