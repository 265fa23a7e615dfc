/** Actions of random use on a page. */
import { setTimeout as delay } from "node:timers/promises";

/**
 * @typedef {object} Action
 * @property {string} name
 * @property {number} weight how often it is drawn, relative to the others
 * @property {(use: Use) => Promise<boolean> | boolean} [when] whether it can be done now; always, where absent
 * @property {(use: Use) => Promise<string | void>} act does it; returns the chosen item for the log
 *
 * @typedef {object} Use
 * @property {import("./watched_page.mjs").WatchedPage} watched
 * @property {import("@playwright/test").Page} page
 * @property {import("./dice.mjs").Dice} dice
 */

/** Links that are opened within the page: every model, old versions, texts in the fragment, and damaged ones. */
export const LINKS = [
	"?v=2&preset=riesling&seed=7",
	"?v=1&preset=short-conical",
	"?v=2&model=tree&preset=twin",
	"?v=2&model=tree&preset=oak&n=200",
	"?v=2&model=root",
	"?v=2&model=leaf&preset=grapevine",
	"?v=2&model=flower",
	"?v=2&model=growth",
	"?v=2&model=stand",
	"?v=2&model=grammar&seed=83247",
	"?v=2&model=grammar&preset=row-of-trees",
	"?v=2&model=grammar#g=c3RyYXc",
	"?v=9&model=nettle&preset=x&seed=-1",
	"#controls",
	"?v=2",
];

const FILES = [
	["plant.lsys", "axiom: A\nderivation length: 5\nA --> F(0.1)[+(30)A][-(30)A]F(0.1)A\n"],
	["broken.lsys", "axiom: F(\n"],
	["plant.json", JSON.stringify({ version: 2, model: "bunch", preset: "merlot", seed: 3 })],
	["broken.json", '{"version": 2, "model": '],
	["box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"],
	["broken.glb", "glTF"],
	["notes.txt", "This is not a plant."],
];

const TEXTS = ["F(0.1)", "[+(25)A]", "\n", "A --> F(0.2)A\n", "}", "#define a 1\n", "axiom: A\n", "°", "-1e9"];
const KEYS = [
	"n",
	"?",
	"Control+s",
	"Control+z",
	"Control+y",
	"Escape",
	"Tab",
	"Shift+Tab",
	"Enter",
	" ",
	"ArrowRight",
];
const SIZES = [
	{ width: 390, height: 780 },
	{ width: 800, height: 500 },
	{ width: 1280, height: 720 },
];

/** Clickable elements; outside an open dialog there are none. */
const CLICKABLE =
	"button, summary, [role=button], [role=tab], [role=switch], input[type=checkbox], input[type=radio], a[href^='#']";

/**
 * Draws one of the elements that a pointer can reach, by its place in the page.
 *
 * @param {Use} use
 * @param {string} selector
 * @returns {Promise<{ x: number, y: number, width: number, height: number, name: string } | undefined>} in CSS pixels of the window
 */
async function reachable({ page, dice }, selector) {
	const share = dice.next();
	return page.evaluate(
		([wanted, part]) => {
			const found = [];
			/** Handles are in shadow trees. */
			const look = (root) => {
				found.push(...root.querySelectorAll(wanted));
				for (const each of root.querySelectorAll("*")) if (each.shadowRoot) look(each.shadowRoot);
			};
			look([...document.querySelectorAll("dialog[open]")].at(-1) ?? document);
			const visible = found.filter(
				(each) =>
					each.checkVisibility({ visibilityProperty: true }) && !each.matches(":disabled, [aria-disabled=true]"),
			);
			const chosen = visible[Math.floor(part * visible.length)];
			if (!chosen) return undefined;
			chosen.scrollIntoView({ block: "nearest", inline: "nearest", behavior: "instant" });
			const { x, y, width, height } = chosen.getBoundingClientRect();
			const name = chosen.getAttribute("aria-label") ?? chosen.textContent ?? "";
			return { x, y, width, height, name: `${chosen.localName} “${name.trim().replace(/\s+/g, " ").slice(0, 40)}”` };
		},
		[selector, share],
	);
}

/** An action that clicks one of the elements that a selector matches. @param {string} selector */
export const clicks = (selector) => async (use) => {
	const box = await reachable(use, selector);
	if (!box) return "nothing there";
	await use.page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
	return box.name;
};

/** @param {string} selector of the elements that are pressed and dragged by up to `reach` pixels */
const drags = (selector, reach) => async (use) => {
	const box = await reachable(use, selector);
	if (!box) return "nothing there";
	const { mouse } = use.page;
	const { dice } = use;
	const [x, y] = [box.x + box.width * dice.between(0.2, 0.8), box.y + box.height * dice.between(0.2, 0.8)];
	await mouse.move(x, y);
	await mouse.down();
	for (let step = 0; step < 5; step++)
		await mouse.move(x + dice.between(-reach, reach), y + dice.between(-reach, reach));
	await mouse.up();
	return box.name;
};

/** Goes to an address within the page, as the browser does by Back and Forward. */
const visit = (page, link) =>
	page.evaluate((to) => {
		history.pushState(null, "", to);
		dispatchEvent(new PopStateEvent("popstate"));
	}, link);

/** Whether the browser's history has an entry of the app on that side of the present one. */
const hasEntry = (page, step) =>
	page.evaluate((by) => {
		const { navigation } = window;
		return navigation.entries()[navigation.currentEntry.index + by]?.sameDocument === true;
	}, step);

async function dropFile({ page, dice }) {
	const [name, text] = dice.of(FILES);
	await page.evaluate(
		([fileName, content]) => {
			const data = new DataTransfer();
			data.items.add(new File([content], fileName));
			for (const type of ["dragenter", "dragover", "drop"])
				document.body.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
		},
		[name, text],
	);
	return name;
}

/** @type {readonly Action[]} */
export const ACTIONS = [
	{ name: "click", weight: 20, act: clicks(CLICKABLE) },
	{ name: "choose a preset", weight: 5, act: clicks(".preset") },
	{ name: "drag a slider", weight: 10, act: drags("input[type=range]", 60) },
	{ name: "drag a handle", weight: 8, act: drags("[data-handle]", 40) },
	{ name: "drag the 3-D view", weight: 5, act: drags("canvas.stage-surface", 120) },
	{ name: "drag a number in the text", weight: 2, act: drags(".cm-line span", 40) },
	{
		name: "turn the wheel",
		weight: 3,
		async act(use) {
			const box = await reachable(use, "canvas.stage-surface, .panel, .strip");
			if (!box) return "nothing there";
			await use.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
			await use.page.mouse.wheel(0, use.dice.between(-400, 400));
			return box.name;
		},
	},
	{
		name: "type",
		weight: 6,
		async act(use) {
			const box = await reachable(
				use,
				".cm-content, input[type=search], input[type=text], input[type=number], textarea",
			);
			if (!box) return "nothing there";
			await use.page.mouse.click(box.x + box.width / 2, box.y + Math.min(box.height / 2, 40));
			const text = use.dice.of(TEXTS);
			await use.page.keyboard.type(text);
			return `${JSON.stringify(text)} in ${box.name}`;
		},
	},
	{
		name: "choose from a list",
		weight: 2,
		async act(use) {
			const lists = use.page.locator("select:visible:enabled");
			const count = await lists.count();
			if (count === 0) return "nothing there";
			const list = lists.nth(use.dice.below(count));
			const options = await list.locator("option").count();
			const index = use.dice.below(options);
			// A list behind a dialog cannot be reached, and one may go away meanwhile.
			await list.selectOption({ index }, { timeout: 2000 }).catch(() => {});
			return `option ${index}`;
		},
	},
	{
		name: "press a key",
		weight: 8,
		async act({ page, dice }) {
			const key = dice.of(KEYS);
			await page.keyboard.press(key);
			return key;
		},
	},
	{ name: "undo", weight: 5, act: ({ page }) => page.keyboard.press("Control+z") },
	{ name: "redo", weight: 3, act: ({ page }) => page.keyboard.press("Control+Shift+z") },
	{
		name: "open a link",
		weight: 6,
		async act({ page, dice }) {
			const link = dice.of(LINKS);
			await visit(page, link);
			return link;
		},
	},
	{
		name: "go back",
		weight: 5,
		when: ({ page }) => hasEntry(page, -1),
		act: ({ page }) => page.evaluate(() => history.back()),
	},
	{
		name: "go forward",
		weight: 3,
		when: ({ page }) => hasEntry(page, 1),
		act: ({ page }) => page.evaluate(() => history.forward()),
	},
	{ name: "drop a file", weight: 3, act: dropFile },
	{ name: "leave a dialog", weight: 5, act: ({ page }) => page.keyboard.press("Escape") },
	{
		name: "resize the window",
		weight: 2,
		async act({ page, dice }) {
			const size = dice.of(SIZES);
			await page.setViewportSize(size);
			return `${size.width} × ${size.height}`;
		},
	},
	{
		name: "change the system's theme",
		weight: 1,
		async act({ page, dice }) {
			const colorScheme = dice.of(/** @type {const} */ (["light", "dark"]));
			const reducedMotion = dice.of(/** @type {const} */ (["reduce", "no-preference"]));
			await page.emulateMedia({ colorScheme, reducedMotion });
			return `${colorScheme}, ${reducedMotion}`;
		},
	},
	{
		name: "lose the WebGL context",
		weight: 2,
		act: ({ page, dice }) =>
			page.evaluate(
				(restoreAfter) => {
					for (const reference of window.webglContexts) {
						const lose = reference.deref()?.getExtension("WEBGL_lose_context");
						lose?.loseContext();
						setTimeout(() => lose?.restoreContext(), restoreAfter);
					}
				},
				dice.between(50, 800),
			),
	},
	{
		name: "go offline",
		weight: 2,
		when: ({ watched }) => watched.isOnline,
		act: ({ watched }) => watched.setOnline(false),
	},
	{
		name: "go online",
		weight: 20,
		when: ({ watched }) => !watched.isOnline,
		act: ({ watched }) => watched.setOnline(true),
	},
	{
		name: "freeze",
		weight: 1,
		async act({ watched: { devtools }, dice }) {
			await devtools.send("Page.setWebLifecycleState", { state: "frozen" });
			await delay(dice.between(200, 1500));
			await devtools.send("Page.setWebLifecycleState", { state: "active" });
		},
	},
	{ name: "reload", weight: 0.4, when: ({ watched }) => watched.isOnline, act: ({ watched }) => watched.reload() },
	{ name: "wait", weight: 4, act: ({ dice }) => delay(dice.between(100, 1500)) },
];
