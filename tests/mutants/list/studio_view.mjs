/** The 3-D view in the studio, the page's keys, and links that are read late. */
const SRC = "web/src/app";
const TESTS = "tests/web/app";

export default [
	{
		file: `${SRC}/solid_view.ts`,
		suites: [`${TESTS}/solid_view.test.ts`],
		faults: [
			{
				id: "solid-view-never-held",
				find: "this.#view.holdView(held || instead !== undefined);",
				replace: "",
				breaks: "the view moves away under a drag",
			},
			{
				id: "solid-view-old-colours",
				find: "|| look !== this.#look)",
				replace: ")",
				breaks: "a colour changes nothing in the view",
			},
			{
				id: "solid-view-light-for-ever",
				find: 'if (dark !== this.#dark) this.#view.setTheme(dark ? "dark" : "light");',
				replace: "",
				breaks: "the view stays light in the dark theme",
			},
			{
				id: "solid-view-fetches-without-end",
				find: "if (shown.model !== this.#failedModel) void",
				replace: "void",
				breaks: "a script that does not come is fetched hundreds of times a second",
				hangs: true,
			},
			{
				id: "solid-view-never-fetches-again",
				find: "this.#failedModel = undefined;\n\t\tconst instead",
				replace: "const instead",
				breaks: "a model whose script did not come once is never drawn, though the network is back",
				hangs: true,
			},
			{
				id: "solid-view-pictures-overlap",
				find: "this.#picturesInProgress--;",
				replace: "this.#picturesInProgress = 0;",
				breaks: "of two pictures at once the second shows what a tool compares with",
			},
		],
	},
	{
		file: "web/src/render/orbit_keys.ts",
		suites: [`${TESTS}/solid_view.test.ts`],
		faults: [
			{
				id: "orbit-reversed",
				find: "ArrowLeft: [-1, 0],",
				replace: "ArrowLeft: [1, 0],",
				breaks: "the left arrow turns to the right",
			},
			{
				id: "zoom-reversed",
				find: "view.zoom(1 / ZOOM_STEP);",
				replace: "view.zoom(ZOOM_STEP);",
				breaks: "minus goes nearer",
			},
		],
	},
	{
		file: "web/src/app/shortcuts.ts",
		suites: ["tests/web/app/shortcut_keys.test.ts"],
		faults: [
			{
				id: "shortcuts-behind-dialogs",
				find: ' || document.querySelector("dialog[open]")',
				replace: "",
				breaks: "Ctrl and Z in a dialog undo a step of the plant behind it",
			},
		],
	},
	{
		file: "web/src/app/late_link.ts",
		suites: ["tests/web/app/late_link.test.ts"],
		faults: [
			{
				id: "late-link-overwrites",
				find: "if (studio.state.history === history) {",
				replace: "if (history) {",
				breaks: "what was changed before a long link was read to its end is lost",
			},
		],
	},
];
