/** Plants saved in the browser. */
const SRC = "web/src/app/saved";
const TESTS = "tests/web/app/saved";
const E2E = "tests/e2e/saved.spec.ts";

export default [
	{
		file: `${SRC}/library.ts`,
		suites: [`${TESTS}/library.test.ts`],
		faults: [
			{
				id: "saved-unkept-forgotten",
				find: "else this.#unstored.set(each.id, each);",
				replace: "",
				breaks: "what a full disk does not take is lost",
			},
			{
				id: "saved-other-tabs-untold",
				find: 'if (done) this.#tabs?.postMessage("changed");',
				replace: "",
				breaks: "a change in one tab is not seen in the other",
			},
			{
				id: "saved-twice-brought",
				find: "existing.add(sameness(each));",
				replace: "",
				breaks: "twins in a file both come",
			},
			{
				id: "saved-pictures-lost-by-deleting",
				find: "picture ? new Blob([picture]) : pictures.get(saved.id)",
				replace: "undefined",
				breaks: "what was deleted comes back without its picture",
			},
			{
				id: "saved-import-undone-with-all",
				find: "this.all.filter(({ id }) => step.ids.has(id))",
				replace: "this.all",
				breaks: "the button that undoes an import counts specimens that it does not delete",
			},
			{
				id: "saved-import-undone-once",
				find: "\t\tthis.#addStep(step);\n\t\treturn undefined;",
				replace: "\t\treturn undefined;",
				breaks: "an import that could not be undone now cannot be undone later",
			},
			{
				id: "saved-others-deletion-undone",
				find: "removed = edited(stored, { put: this.unstored }).filter",
				replace: "removed = this.all.filter",
				breaks: "undo brings back what another tab has deleted",
			},
		],
	},
	{
		file: "web/src/app/parts/saved_list.ts",
		suites: [`${E2E}: of 10,000 specimens`],
		faults: [
			{
				id: "saved-list-loses-the-focus",
				find: ", [Math.floor(active / this.#columns)]);",
				replace: ");",
				breaks: "the focus vanishes when the list is scrolled, and keys reach no card out of sight",
			},
			{
				id: "saved-list-selects-what-is-hidden",
				find: "this.#selected = new Set(this.#found().flatMap(({ id }) => (this.#selected.has(id) ? id : [])));",
				replace: "",
				suites: [`${E2E}: several are selected`],
				breaks: "specimens that a search leaves out are deleted with what it finds",
			},
		],
	},
	{
		file: "web/src/ui/virtual_rows.ts",
		suites: [`${E2E}: of 10,000 specimens`],
		faults: [
			{
				id: "virtual-rows-all-drawn",
				find: "withRows(defaultRangeExtractor(range), pinned, count)",
				replace: "withRows(Array.from({ length: count }, (_, index) => index), kept, count)",
				breaks: "a library of 10,000 specimens puts 132,000 elements into the page",
			},
		],
	},
	{
		file: "web/src/ui/long_list.ts",
		suites: ["tests/e2e/long_texts.spec.ts: of 15,000 constants"],
		faults: [
			{
				id: "long-list-tab-jumps",
				find: "[at - 1, at, at + 1]",
				replace: "[at]",
				breaks: "the Tab key goes from a constant out of sight to one that is not the next",
			},
		],
	},
	{
		file: "web/src/app/parts/stage.ts",
		suites: ["tests/e2e/trouble.spec.ts: without WebGL 2 the button of the grammar"],
		faults: [
			{
				id: "stage-no-tools-without-webgl",
				find: "this.#solid || this.#trouble ?",
				replace: "this.#solid && !this.#trouble ?",
				breaks: "without WebGL 2 no button opens the grammar",
			},
		],
	},
	{
		file: `${SRC}/saved.ts`,
		suites: [`${TESTS}/library_file.test.ts`],
		faults: [
			{
				id: "saved-links-unlimited",
				find: "query.length > LONGEST_QUERY || ",
				replace: "",
				breaks: "a link of any length is kept",
			},
			{
				id: "saved-giant-pictures",
				find: "Math.max(width, height) > LONGEST_SIDE",
				replace: "false",
				breaks: "a picture of few bytes fills the memory",
			},
		],
	},
	{
		file: `${SRC}/indexed_store.ts`,
		suites: [`${E2E}: two tabs see`],
		faults: [
			{
				id: "saved-database-held",
				find: "database.close();",
				replace: "",
				breaks: "a later version in another tab waits for ever",
			},
			{
				id: "saved-old-pictures-lost",
				find: "if (oldVersion === 1 && transaction)",
				replace: "if (oldVersion > 2 && transaction)",
				breaks: "pictures of former versions are gone",
				suites: ["tests/e2e/saved_pictures.spec.ts: pictures of the first layout"],
			},
		],
	},
	{
		file: `${SRC}/on_screen.ts`,
		suites: [`${E2E}: everything goes into one file`],
		faults: [
			{
				id: "saved-fingerprint-not-compared",
				find: "if (saved.fingerprint === undefined) return;",
				replace: "return;",
				breaks: "one that grows otherwise than when it was saved is opened without a word",
			},
		],
	},
	{
		file: `${SRC}/own_library.ts`,
		suites: [`${E2E}: plants that do not fit on a full disk`],
		faults: [
			{
				id: "saved-left-unasked",
				find: "if (library.unstored.length > 0) event.preventDefault();",
				replace: "",
				breaks: "who leaves the page with something unkept is not asked",
			},
		],
	},
];
