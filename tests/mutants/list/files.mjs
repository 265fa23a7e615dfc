/** Downloads, and opening files in the page. */
export default [
	{
		file: "web/src/app/files/plant_to_save.ts",
		suites: ["tests/web/app/plant_to_save.test.ts"],
		faults: [
			{
				id: "saved-in-a-stale-look",
				find: "look: lookOf(shown, requested)",
				replace: "look: shown.from.look",
				breaks: "a download has the colours from before the last change",
			},
			{
				id: "saved-before-it-has-grown",
				find: "if (studio.state.pending) return;",
				replace: "",
				breaks: "a download is of the plant before",
			},
		],
	},
	{
		file: "web/src/generate/files/exporter.ts",
		suites: ["tests/web/generate/files/exporter.test.ts"],
		faults: [
			{
				id: "exporter-workers-pile-up",
				find: "worker.terminate();",
				replace: "",
				breaks: "every download leaves a worker behind",
			},
			{
				id: "exporter-deaf-to-cancelling",
				find: 'signal?.addEventListener("abort", abort);',
				replace: "",
				breaks: "a download that takes its time cannot be cancelled",
				hangs: true,
			},
			{
				id: "exporter-uncloneable-leaks",
				find: "end(() => reject(error));",
				replace: "reject(error);",
				breaks: "a plant that cannot be copied to a worker leaves the worker behind",
			},
		],
	},
	{
		file: "web/src/formats/plant_files.ts",
		suites: ["tests/web/generate/files/make.test.ts"],
		faults: [
			{
				id: "make-instances-everywhere",
				find: "exportGlb(shown, about, { translucent })",
				replace: "exportGlb(shown, about, { translucent, instancing: true })",
				breaks: "a plain GLB wants readers that know instances",
			},
		],
	},
	{
		file: "web/src/app/address.ts",
		suites: ["tests/web/app/address.test.ts"],
		faults: [
			{
				id: "address-back-leaves-the-app",
				find: "if (isOtherOrigin) this.#history.pushState(",
				replace: "if (isOtherOrigin && false) this.#history.pushState(",
				breaks: "Back leaves the app after three presets",
			},
		],
	},
	{
		file: "web/src/app/studio.ts",
		suites: ["tests/web/app/studio.test.ts"],
		faults: [
			{
				id: "studio-back-is-a-new-step",
				find: "if (leadsTo(past.at(-1))) this.undo();",
				replace: "if (past.length < 0) this.undo();",
				breaks: "Back and Undo go different ways",
			},
		],
	},
	{
		file: "web/src/generate/files/aged.ts",
		suites: ["tests/web/generate/files/aged.test.ts"],
		faults: [
			{
				id: "aged-always-itself",
				find: "restore(model, { [AGE]: age }, specimen)",
				replace: "restore(model, {}, specimen)",
				breaks: "the growth is the same plant twenty-five times",
			},
			{
				id: "aged-heeded-by-all",
				find: "return table.isActive(specimen, entry) &&",
				replace: "return",
				breaks: "a growth is offered of the paper's bunches, which have no age",
			},
			{
				id: "aged-of-any-text",
				find: "(ages?.(specimen) ?? true)",
				replace: "true",
				breaks: "a growth is offered of flowers whose text says nothing of age: twenty-five times the same",
			},
			{
				id: "aged-by-percent",
				find: "const life = entry.default - entry.min;",
				replace: "const life = 100;",
				breaks: "the growth of a flower is a wilted one",
			},
		],
	},
	{
		file: "web/src/models/for_text.ts",
		suites: ["tests/web/models/for_text.test.ts"],
		faults: [
			{
				id: "any-text-before-its-own-model",
				find: "models.find(({ details }) => details.some(({ claims }) => claims?.(text))) ??",
				replace: "models.find(({ details }) => details.some(({ claims, takesAny }) => takesAny || claims?.(text))) ??",
				breaks: "a tree's grammar and a stand's plan are taken for L-systems",
			},
			{
				id: "file-names-before-texts",
				find: "const ending = /\\.\\w+$/.exec(fileName.toLowerCase())?.[0];",
				replace: "const ending = undefined;",
				breaks: "the ending of a file's name means nothing where the text has no sign of a model",
			},
		],
	},
	{
		file: "web/src/specimen/text_file.ts",
		suites: ["tests/web/models/for_text.test.ts"],
		faults: [
			{
				id: "text-file-comment-ended-by-a-value",
				find: '.replaceAll("*/", "*%2F")',
				replace: "",
				breaks: "a value in a file's first line ends its comment",
			},
			{
				id: "text-file-keeps-its-first-line",
				find: "text: file.slice(line.length)",
				replace: "text: file",
				breaks: "each time a text is opened and downloaded it has one more line",
			},
		],
	},
];
