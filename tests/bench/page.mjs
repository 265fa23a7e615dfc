/**
 * `npm run bench -- page [FOLDER]`: costs of texts in the built page, or one built before: a million modules, typing
 * beside 10,000 segments, a drag of the garden tree's areas. Twice: with drawing switched off (WebGL's draws do
 * nothing, all calls to them stay), and with software drawing. Tasks are measured by CPU time of the page's thread.
 */
import { loadavg } from "node:os";
import { join } from "node:path";
import { build, preview } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { launch } from "../browsers/chromium.mjs";
import { withoutDrawing } from "../e2e/without_drawing.mjs";
import { followed, forget, noteAll } from "./page_notes.mjs";
import { median, printTable } from "./statistics.mjs";
import { heaviestIn, tasksOf } from "./trace.mjs";

const built = join(repository, "build/bench/page");
const configFile = join(repository, "vite.config.ts");
const viewport = { width: 1024, height: 640 };
/** 1,179,640 modules, 131,071 of them lines; and four times as many. */
const large = (steps) =>
	`derivation length: ${steps}\naxiom: A(1)\nA(s) --> F(s)[+(31)/(90)A(s/1.456)][-(29)A(s/1.456)]\n`;
const [MILLION, MILLIONS] = [large(17), large(19)];
/** 9,841 segments. */
const TEN_THOUSAND =
	"#define bend 3\nderivation length: 9\naxiom: A(1)\nA(s) --> F(s)[+(bend)A(s*0.7)]/(120)[+(bend)A(s*0.7)]/(120)[+(bend)A(s*0.7)]\n";
const TEXTS = 5;
const CANCELS = 5;
const STEPS = 16;
/** Software takes seconds for one. */
const STEPS_DRAWN = 5;
/** Wait after the last input, milliseconds: all resulting work has started by then. */
const REST = 2500;
/** No task of the page's thread is to be longer; milliseconds. */
const AIM = 50;

const fixed = (number) => (Number.isFinite(number) ? number.toFixed(number < 10 ? 1 : 0) : "–");

/** @param {string | undefined} folder with a page built before; the app is built where absent */
export async function benchPage(folder) {
	process.env.NODE_ENV = "production";
	// As it is published, but that functions keep their names.
	const own = { outDir: built, minify: false };
	if (!folder) await build({ root: join(repository, "web"), configFile, build: own, logLevel: "error" });
	const server = await preview({
		configFile,
		preview: { port: 0, host: "localhost" },
		build: { outDir: folder ?? built },
		logLevel: "error",
	});
	const browser = await launch();
	const opener = (drawn) => (search) => openPage(browser, server.resolvedUrls.local[0], search, drawn);
	console.log(`Load of the machine before: ${loadavg()[0].toFixed(1)}`);
	try {
		await benchMillion(browser, opener(false));
		await benchSteps("Typing a character beside 9,841 segments (aim: the new plant within 100 ms)", typing, opener);
		await benchSteps("A step of a drag of the garden tree's second area (aim 50 ms)", dragging, opener);
	} finally {
		await browser.close();
		await server.close();
	}
}

async function openPage(browser, address, search, drawn) {
	const page = await browser.newPage({ viewport, serviceWorkers: "block" });
	if (!drawn) await page.addInitScript(withoutDrawing);
	await page.addInitScript(noteAll);
	await page.goto(`${address}${search}`);
	await page.waitForFunction(() => document.querySelector("[data-fingerprint]"));
	await page.waitForTimeout(REST);
	return page;
}

/** Puts a text in the place of the one that is open, and waits for its plant to be at rest. */
async function write(page, text) {
	await page.getByRole("textbox", { name: "Grammar", exact: true }).press("ControlOrMeta+a");
	await page.keyboard.insertText(text);
	await page.waitForFunction(() => window.notes.at(-1)?.at < performance.now() - 1500, undefined, { polling: 100 });
}

async function edit(page, text) {
	await page.getByRole("button", { name: "Grammar", exact: true }).first().click();
	await page.getByRole("textbox", { name: "Grammar", exact: true }).waitFor();
	await write(page, text);
}

async function benchMillion(browser, open) {
	const page = await open("?v=2&model=grammar&preset=koch-curve-a");
	await edit(page, "axiom: F\n");
	const texts = [];
	for (let i = 0; i < TEXTS; i++) {
		await write(page, "axiom: F\n");
		await forget(page);
		await browser.startTracing(page, { categories: ["toplevel", "devtools.timeline", "v8"] });
		await write(page, MILLION);
		const tasks = tasksOf(JSON.parse((await browser.stopTracing()).toString()).traceEvents);
		texts.push({ tasks, notes: await page.evaluate(() => window.notes) });
	}
	await write(page, "axiom: F\n");
	await browser.startTracing(page, {
		categories: ["toplevel", "devtools.timeline", "v8", "disabled-by-default-v8.cpu_profiler"],
	});
	await page.waitForTimeout(500);
	await write(page, MILLION);
	const named = tasksOf(JSON.parse((await browser.stopTracing()).toString()).traceEvents);
	const longest = texts.map(({ tasks }) => tasks[0].milliseconds);
	const after = (kind) => texts.map(({ notes }) => at(notes, kind) - at(notes, "hand"));
	printTable(`A text of 1,179,640 modules is pasted, medians of ${TEXTS}`, [
		["", "aim ms", "ms"],
		["longest task of the page's thread", AIM, fixed(median(longest))],
		["the longest of all", AIM, fixed(Math.max(...longest))],
		[`tasks over ${AIM} ms, in all`, 0, texts.flatMap(({ tasks }) => tasks.filter((t) => t.milliseconds > AIM)).length],
		["until the page says that it grows", 200, fixed(median(after("growing")))],
		["until the plant is on the stage", "–", fixed(median(after("shown")))],
	]);
	// Where the profiler begins is a task of its own.
	for (const task of named.slice(0, 4)) console.log(`  ${fixed(task.milliseconds)} ms: ${heaviestIn(task)}`);
	await benchCancels(page);
	await page.close();
}

const at = (notes, kind) => notes.find(({ what }) => what === kind)?.at ?? Number.NaN;

/** Time until the page cancels a growth. */
async function benchCancels(page) {
	const ways = [
		["by its button", () => page.getByRole("button", { name: "Cancel", exact: true }).click(), "calm"],
		["by Escape", () => page.keyboard.press("Escape"), "calm"],
		["by the next character: until that is requested", () => page.keyboard.press("Space"), "requested"],
	];
	const rows = [["cancelling four million modules", "aim ms", "ms", "the slowest", "of", "worker ended"]];
	for (const [name, cancel, answer] of ways) {
		const times = [];
		for (let i = 0; i < CANCELS; i++) {
			await write(page, "axiom: F\n");
			await page.getByRole("textbox", { name: "Grammar", exact: true }).press("ControlOrMeta+a");
			await page.keyboard.insertText(MILLIONS);
			await page.locator(".growing").waitFor();
			await forget(page);
			await cancel();
			await page.waitForTimeout(300);
			const notes = await page.evaluate(() => window.notes);
			times.push([at(notes, answer) - at(notes, "hand"), at(notes, "ended") - at(notes, "hand")]);
		}
		const answered = times.map(([time]) => time);
		const ended = median(times.map(([, time]) => time));
		rows.push([name, 200, fixed(median(answered)), fixed(Math.max(...answered)), CANCELS, fixed(ended)]);
	}
	printTable(`Cancelling, medians of ${CANCELS}`, rows);
}

async function typing(page) {
	await edit(page, TEN_THOUSAND);
	await page.keyboard.press("ControlOrMeta+Home");
	await page.keyboard.press("End");
	return (step) => page.keyboard.press(step % 2 ? "Backspace" : "1");
}

async function dragging(page) {
	const handle = page.getByRole("button", { name: /^Area 2, .*: x / });
	await handle.waitFor();
	await page.waitForTimeout(500);
	const { x, y, width, height } = await handle.boundingBox();
	const [left, top] = [x + width / 2, y + height / 2];
	await page.mouse.move(left, top);
	await page.mouse.down();
	return (step) => page.mouse.move(left + 8 * Math.sin(step + 1), top - step - 1);
}
typing.search = "?v=2&model=grammar&preset=koch-curve-a";
dragging.search = "?v=2&model=grammar&preset=topiary-garden-tree";

/** Steps of a drag, each timed until it is drawn: without drawing, and with software drawing. */
async function benchSteps(title, begin, opener) {
	const ways = [
		["event → requested from the worker", "requested"],
		["the core grows", "core"],
		["to the worker and back", "crossing"],
		["event → buffers", "buffers"],
		["three.js's objects are made", "showing"],
		["event → handed to three.js", "shown"],
		["event → frame submitted to the graphics card", "submitted"],
		["event → drawn", "drawn"],
		["MB from the core", "megabytes"],
		["MB sent to the graphics card", "sent"],
	];
	const columns = [];
	for (const drawn of [false, true]) {
		const page = await opener(drawn)(begin.search);
		const step = await begin(page);
		for (let i = 0; i < 2; i++) await followed(page, () => step(i));
		const times = [];
		for (let i = 0; i < (drawn ? STEPS_DRAWN : STEPS); i++) times.push(await followed(page, () => step(i)));
		columns.push(times.filter(Boolean));
		await page.close();
	}
	const of = (times, key) => fixed(median(times.map((each) => each[key]).filter(Number.isFinite)));
	printTable(`${title}, ms, medians of ${STEPS}, of ${STEPS_DRAWN} where it is drawn`, [
		["", "without drawing", "drawn by software"],
		...ways.map(([words, key]) => [words, ...columns.map((times) => of(times, key))]),
		["steps that were followed", ...columns.map((times) => times.length)],
	]);
}
