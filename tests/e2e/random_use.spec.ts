import type { BrowserContext } from "@playwright/test";
import { clicks } from "../random_use/actions.mjs";
import { countTo, use } from "../random_use/random_use.mjs";
import { expect, test } from "./fixtures";

/** Actions of the short run: about 20 s. */
const SHORT = 50;

test("random use finds no fault in the page", async ({ context, baseURL }) => {
	const run = await use(context, `${baseURL}/?v=2`, { seed: 5, numbers: countTo(SHORT) });
	expect(run.fault, run.log.join("\n")).toBeUndefined();
	expect(run.actions).toBe(SHORT);
});

/** Clicks a button of a small page, whose script is given, twice. */
async function clickTwice(context: BrowserContext, script: string) {
	const address = "http://localhost/small";
	const body = `<!doctype html><p data-fingerprint></p><button>Press</button><script>
		document.querySelector("button").onclick = () => { ${script} };</script>`;
	await context.route("http://localhost/**", (route) =>
		route.fulfill(route.request().url() === address ? { contentType: "text/html", body } : { body: "" }),
	);
	const actions = [{ name: "press", weight: 1, act: clicks("button") }];
	return use(context, address, { seed: 1, numbers: countTo(2), actions });
}

const FAULTS = [
	{ title: "an uncaught error", script: `setTimeout(() => { throw new Error("broken"); })`, found: "Error: broken" },
	{ title: "an error in the console", script: `console.error("wrong")`, found: "console .*: wrong" },
	{
		title: "requests without end",
		// More than twice as many as one action may cause: the driver may count some of them with the next action.
		script: `for (let i = 0; i < 100; i++) fetch("/missing")`,
		found: String.raw`One action requested http://localhost/missing \d+ times`,
	},
	{
		title: "a blocked thread",
		script: "const end = performance.now() + 9000; while (performance.now() < end);",
		found: String.raw`The page's thread was blocked for \d+ ms`,
		long: true,
	},
];

for (const { title, script, found, long } of FAULTS) {
	test(`random use finds ${title}`, long ? { tag: "@long" } : {}, async ({ context }) => {
		const run = await clickTwice(context, script);
		expect(run.fault).toMatch(new RegExp(found));
		expect(run.log[0]).toBe("1 press: button “Press”");
	});
}

test("random use finds no fault in a page that has none", async ({ context }) => {
	const run = await clickTwice(context, "");
	expect(run).toMatchObject({ fault: undefined, actions: 2 });
});
