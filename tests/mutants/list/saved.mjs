/** What a person saves in the browser. */
const SRC = "web/src/studio/saved";
const TESTS = "tests/web/studio/saved";
const E2E = "tests/e2e/saved.spec.ts";

export default [
	{
		file: `${SRC}/library.ts`,
		suites: [`${TESTS}/library.test.ts`],
		faults: [
			{
				id: "saved-unkept-forgotten",
				find: "else this.#unkept.set(each.id, each);",
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
				find: "known.add(sameness(each));",
				replace: "",
				breaks: "twins in a file both come",
			},
			{
				id: "saved-pictures-lost-by-deleting",
				find: "{ ...before, ...gone }",
				replace: "gone",
				breaks: "what was deleted comes back without its picture",
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
		file: `${SRC}/indexed_shelf.ts`,
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
		suites: [`${E2E}: what a full disk`],
		faults: [
			{
				id: "saved-left-unasked",
				find: "if (library.unkept.length > 0) event.preventDefault();",
				replace: "",
				breaks: "who leaves the page with something unkept is not asked",
			},
		],
	},
];
