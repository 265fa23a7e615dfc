/** The library, its package, and releases. */
const SRC = "web/src/library";

export default [
	{
		file: `${SRC}/read_request.ts`,
		suites: ["tests/web/library/read_request.test.ts"],
		faults: [
			{
				id: "library-takes-what-cannot-be",
				find: "if (notes.length === 0) return specimen;",
				replace: "return specimen;",
				breaks: "a program's value out of range is changed without a word",
			},
			{
				id: "library-values-of-version-1",
				find: "{ v: SPECIMEN_VERSION, ...values, model: model.name }",
				replace: "{ ...values }",
				breaks: "values by their keys mean what links of version 1 meant",
			},
			{
				id: "library-link-is-a-preset",
				find: 'if (query < 0 && hash < 0 && !source.includes("://")) return undefined;',
				replace: "if (query < 0) return undefined;",
				breaks: "an address that has all in its fragment is taken for a preset's name",
			},
		],
	},
	{
		file: `${SRC}/grow.ts`,
		suites: ["tests/web/library/grow.test.ts"],
		faults: [
			{
				id: "library-keeps-notes-of-links",
				find: "notes: [...notes.map((note) => note.text), ...found.notes, ...plant.notes],",
				replace: "notes: [...plant.notes],",
				breaks: "nobody hears that a link was not used as it was",
			},
			{
				id: "library-says-its-time",
				find: "const plant = untimed(await growHeld(model, found.specimen, { meshes, measures }, signal));",
				replace: "const plant = await growHeld(model, found.specimen, { meshes, measures }, signal);",
				breaks: "the same specimen's JSON is another one each time",
			},
		],
	},
	{
		file: `${SRC}/files.ts`,
		suites: ["tests/web/library/grow.test.ts"],
		faults: [
			{
				id: "library-files-without-meshes",
				find: "if (meshes) return;",
				replace: "return;",
				breaks: "a plant without meshes is written as an empty file",
			},
		],
	},
	{
		file: `${SRC}/three.ts`,
		suites: ["tests/web/library/three.test.ts"],
		faults: [
			{
				id: "three-instances-in-full-light",
				find: "object.instanceColor = tintsOf(shapes[index]);",
				replace: "object.instanceColor = null;",
				breaks: "leaves deep in a crown are as bright as those outside",
			},
			{
				id: "three-meshes-in-full-light",
				find: "const shaded = colours ? { ...mesh, colours } : mesh;",
				replace: "const shaded = mesh;",
				breaks: "stems among berries are as bright as those outside",
			},
		],
	},
	{
		file: "web/src/core/cores.ts",
		suites: ["tests/web/core/cores.test.ts"],
		faults: [
			{
				id: "cores-keep-the-broken",
				find: "if (!(error instanceof CoreError)) this.#cores.delete(wasm);",
				replace: "",
				breaks: "after one plant that broke the core nothing grows any more",
			},
			{
				id: "cores-keep-their-memory",
				find: "if (core.memoryBytes > MAX_MEMORY) this.#cores.delete(wasm);",
				replace: "",
				breaks: "one large plant's memory is kept for good",
			},
		],
	},
	{
		file: "wasm-core/tools/release/release.mjs",
		suites: ["tests/tools/release.test.ts"],
		faults: [
			{
				id: "release-of-what-is-not-committed",
				find: "if (files.length === 0) return;",
				replace: "return;",
				breaks: "a release has what nobody can find in any commit",
			},
			{
				id: "release-by-the-folders-order",
				find: ".sort(([one], [other]) => (one < other ? -1 : 1))",
				replace: "",
				breaks: "the same commit gives archives of other bytes",
			},
		],
	},
];
