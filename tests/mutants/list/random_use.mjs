/** Random use of the page. */
export default [
	{
		file: "tests/random_use/held.mjs",
		suites: ["tests/tools/random_use.test.ts"],
		faults: [
			{
				id: "random-use-counts-what-is-fetched-first",
				find: "samples.slice(Math.ceil(samples.length / 3))",
				replace: "[...samples]",
				breaks: "models that are fetched at first count as a leak",
			},
			{
				id: "random-use-sees-no-leak-of-workers",
				find: "listeners: 1000, workers: 5 }",
				replace: "listeners: 1000 }",
				breaks: "workers that nobody ends are not noticed",
			},
		],
	},
	{
		file: "tests/random_use/dice.mjs",
		suites: ["tests/tools/random_use.test.ts"],
		faults: [
			{
				id: "random-use-does-the-same-each-time",
				find: "Math.imul(number, 0x85ebca6b)",
				replace: "0",
				breaks: "every action of a run is the first one",
			},
			{
				id: "random-use-ignores-weights",
				find: "left -= item.weight;",
				replace: "left -= 0.5;",
				breaks: "a run reloads the page as often as it clicks, and finds no leak",
			},
		],
	},
];
