/**
 * Random use of the built app: draws actions from a table by a seed and checks the page after each. The long test run does
 * so for ten minutes with a random seed (stage `soak`), `npm test` for some actions with a fixed one
 * (tests/e2e/random_use.spec.ts). By hand, on the app as it was last built:
 *
 *     npm run bench -- use                        ten minutes with a random seed
 *     PANICLE_SEED=7 npm run bench -- use 200     the first 200 actions of seed 7
 *     PANICLE_SEED=7 npm run bench -- use 198 200 of seed 7 only actions 198 and 200, on a fresh page
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { setTimeout as delay } from "node:timers/promises";
import { preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { printTable } from "../bench/statistics.mjs";
import { launch } from "../browsers/chromium.mjs";
import { withoutDrawing } from "../e2e/without_drawing.mjs";
import { ACTIONS } from "./actions.mjs";
import { diceOf } from "./dice.mjs";
import { growing } from "./held.mjs";
import { Fault, WatchedPage } from "./watched_page.mjs";

/** @typedef {import("./actions.mjs").Action} Action */
/** @typedef {import("./held.mjs").Held} Held */

/** Duration of a long run, in milliseconds. */
const LONG = 10 * 60_000;
/** Actions between two samples of the page's resources. */
const SAMPLED_EVERY = 60;
/** Actions that are printed when a run fails. */
const PRINTED = 30;
/** Lengths of shorter replays that are tried. */
const SHORTER = [1, 3, 10, 30];

/**
 * Does the action that a seed draws for a number, and checks the page.
 *
 * @param {WatchedPage} watched
 * @param {number} seed
 * @param {number} number
 * @param {string[]} log takes a line for the action, before the page is checked
 * @param {readonly Action[]} actions
 */
async function step(watched, seed, number, log, actions) {
	const dice = diceOf(seed, number);
	const use = { watched, page: watched.page, dice };
	await watched.during(async () => {
		let action = dice.weighted(actions);
		while (action.when && !(await action.when(use))) action = dice.weighted(actions);
		const line = log.push(`${number} ${action.name}`) - 1;
		const chosen = await action.act(use);
		if (typeof chosen === "string") log[line] += `: ${chosen}`;
		await delay(dice.between(0, 200));
	});
}

/**
 * @typedef {object} Run how a run went
 * @property {number} actions how many were done
 * @property {string | undefined} fault the error of the page
 * @property {string[]} log all actions
 * @property {Held[]} samples of the page's resources
 */

/**
 * Uses a page.
 *
 * @param {import("@playwright/test").BrowserContext} context
 * @param {string} address of the app
 * @param {object} plan
 * @param {number} plan.seed
 * @param {Iterable<number>} plan.numbers of the actions, in order
 * @param {() => boolean} [plan.isOver] whether to stop before the numbers end
 * @param {number} [plan.sampledEvery] actions between two samples; none where absent
 * @param {readonly Action[]} [plan.actions]
 * @returns {Promise<Run>}
 */
export async function use(context, address, { seed, numbers, isOver = () => false, sampledEvery, actions = ACTIONS }) {
	/** @type {Run} */
	const run = { actions: 0, fault: undefined, log: [], samples: [] };
	try {
		const watched = await WatchedPage.open(context, address, withoutDrawing);
		let loads = watched.loads;
		for (const number of numbers) {
			if (isOver()) break;
			await step(watched, seed, number, run.log, actions);
			run.actions++;
			if (!sampledEvery || run.actions % sampledEvery > 0) continue;
			if (loads !== watched.loads) run.samples = [];
			loads = watched.loads;
			await watched.during(async () => run.samples.push(await watched.held()));
			const keys = growing(run.samples);
			if (keys.length > 0) throw new Fault(`With use grows: ${keys.join(", ")}.`);
		}
	} catch (error) {
		run.fault = error instanceof Fault ? error.message : error.stack;
	}
	return run;
}

/** 1, 2, 3 … @param {number} [last] */
export function* countTo(last = Number.POSITIVE_INFINITY) {
	for (let number = 1; number <= last; number++) yield number;
}

const numberOf = (line) => Number.parseInt(line, 10);

/**
 * The shortest end of a failed run that fails on a fresh page, too.
 *
 * @param {() => Promise<import("@playwright/test").BrowserContext>} newContext
 * @param {string} address
 * @param {number} seed
 * @param {string[]} log
 * @returns {Promise<number[] | undefined>} numbers of actions
 */
async function shortened(newContext, address, seed, log) {
	for (const length of SHORTER) {
		const numbers = log.slice(-length).map(numberOf);
		if (length > log.length) return undefined;
		const context = await newContext();
		const { fault } = await use(context, address, { seed, numbers });
		await context.close();
		if (fault) return numbers;
	}
	return undefined;
}

/** Prints why a run failed, its last actions, and how to repeat it. @param {Run} run */
function report(seed, { fault, log, actions }) {
	console.error(`\nRandom use failed after ${actions} actions:\n${fault}\n\nThe last actions:`);
	for (const line of log.slice(-PRINTED)) console.error(`  ${line}`);
	console.error(`\nRepeat it: PANICLE_SEED=${seed} npm run bench -- use ${log.length}`);
}

/** The numbers that arguments name: `200` the first 200, several those alone. */
const numbersOf = (args) =>
	args.length > 1 ? args.map(Number) : countTo(args.length > 0 ? Number(args[0]) : undefined);

/**
 * Uses the app as it was last built, for ten minutes or the actions named, and prints how that went.
 *
 * @param {...(number | string)} args one number of actions, or the numbers of several
 * @returns {Promise<{ passed: number, failed: number }>}
 */
export async function randomUse(...args) {
	const seed = Number(process.env.PANICLE_SEED ?? Math.floor(Math.random() * 2 ** 31));
	console.log(`Random use with PANICLE_SEED=${seed}.`);
	if (!existsSync(join(repository, "dist/index.html"))) {
		console.error("The app is not built; run `npm run build` first.");
		return { passed: 0, failed: 1 };
	}
	const configFile = join(repository, "vite.config.ts");
	const server = await preview({ configFile, preview: { port: 0, host: "localhost" }, logLevel: "warn" });
	const browser = await launch();
	// Without the worker that keeps the app, files can fail to come; with it, the app is there without a network.
	const serviceWorkers = seed % 2 === 0 ? "block" : "allow";
	const newContext = () => browser.newContext({ viewport: { width: 800, height: 500 }, serviceWorkers });
	try {
		const address = `${server.resolvedUrls.local[0]}?v=2`;
		const end = Date.now() + LONG;
		const isOver = () => args.length === 0 && Date.now() > end;
		const plan = { seed, numbers: numbersOf(args), isOver, sampledEvery: SAMPLED_EVERY };
		const run = await use(await newContext(), address, plan);
		printTable("Held by the page at rest", [
			["heap, MB", "nodes", "listeners", "workers"],
			...run.samples.map(({ heap, nodes, listeners, workers }) => [heap.toFixed(1), nodes, listeners, workers]),
		]);
		if (run.fault === undefined) {
			console.log(`${run.actions} actions, no fault.`);
			return { passed: 1, failed: 0 };
		}
		report(seed, run);
		const numbers = await shortened(newContext, address, seed, run.log);
		if (numbers) console.error(`Shorter: PANICLE_SEED=${seed} npm run bench -- use ${numbers.join(" ")}`);
		return { passed: 0, failed: 1 };
	} finally {
		await browser.close();
		await server.close();
	}
}
