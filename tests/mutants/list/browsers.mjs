/** Browsers besides Chromium: which there are, what has to be built before they look at it. */
export default [
	{
		file: "tests/browsers/browsers.mjs",
		suites: ["tests/tools/browsers.test.ts"],
		faults: [
			{
				id: "browsers-fail-together",
				find: "if (why) without.push(",
				replace: "if (why) return without.push(",
				breaks: "where one browser is missing the others are not tested either",
			},
			{
				id: "browsers-without-a-screen",
				find: 'firefox: { title: "Firefox", parts: ["firefox", "screen", "mesa"] }',
				replace: 'firefox: { title: "Firefox", parts: ["firefox"] }',
				breaks: "on a fresh machine Firefox is installed without what it draws on",
			},
		],
	},
	{
		file: "tests/selection.mjs",
		suites: ["tests/tools/selection.test.ts"],
		faults: [
			{
				id: "browsers-of-yesterday",
				find: 'browsers: ["wasm core", "app"]',
				replace: "browsers: []",
				breaks: "`npm test -- browsers` looks at the app as it was last built, or at none",
			},
		],
	},
];
