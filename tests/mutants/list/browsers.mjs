/** Browsers besides Chromium: their list, and the builds that they need. */
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
		file: "tests/runner/arguments.mjs",
		suites: ["tests/tools/runner.test.ts"],
		faults: [
			{
				id: "browsers-of-yesterday",
				find: 'browsers: ["wasm", "app"]',
				replace: "browsers: []",
				breaks: "`npm test -- browsers` looks at the app as it was last built, or at none",
			},
			{
				id: "runner-long-in-gate",
				find: "filter((stage) => isLong || !stage.isLong)",
				replace: "filter(() => true)",
				breaks: "the gate runs the stages of the long run",
			},
		],
	},
	{
		file: "tests/runner/changed.mjs",
		suites: ["tests/tools/runner.test.ts"],
		faults: [
			{
				id: "runner-unknown-changes",
				find: "if (!files || files.some((file) => OF_ALL_ROOMS",
				replace: "if (files?.some((file) => OF_ALL_ROOMS",
				breaks: "without git's history no room is sanitized",
			},
			{
				id: "runner-tests-of-a-room",
				find: "(?:wasm-core\\/src|tests\\/core)\\/(?:models",
				replace: "(?:wasm-core\\/src)\\/(?:models",
				breaks: "a room whose tests changed is not sanitized",
			},
		],
	},
	{
		file: "wasm-core/tools/core_queue.mjs",
		suites: ["tests/tools/core_queue.test.ts"],
		faults: [
			{
				id: "queue-keeps-its-order",
				find: "if (at > 0) this",
				replace: "if (at > 99) this",
				breaks: "a page waits for all other cores before the one it requests",
			},
			{
				id: "queue-hides-failures",
				find: 'isBuilt ? "ready" : "failed"',
				replace: '"ready"',
				breaks: "the message of a core that is being built stays where it does not compile",
			},
		],
	},
];
