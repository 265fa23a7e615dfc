/** What has to hold in every browser: the same for each, and what is grown the same as in Node. */
import { existsSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { validateBytes } from "gltf-validator";
import { afterAll, afterEach, beforeAll, describe, expect, it } from "vitest";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { meantBy } from "../golden/links/list";
import { type Driven, home } from "./driven";
import { DrivenPage, KEYS } from "./driven_page";
import { type Host, startHost } from "./host";
import { type Started, startScreen } from "./processes";

/** One of each model, and both procedures of the bunch; few particles, where software draws. */
const LINKS = [
	"?v=2&preset=riesling&seed=7",
	"?v=1&preset=grape-15b",
	"?v=2&model=leaf&preset=birch&n=300",
	"?v=2&model=tree&preset=oak&n=200",
	"?v=2&model=root&n=200",
];

const SMALL = "?v=2&preset=redcurrant&count=6&seed=7";
const LENGTH = "[data-key=l] input[type=range]";
const named = (name: string) => `button[aria-label="${name}"]`;
const handle = (id: string) => `panicle-profile >>> [data-handle="${id}"]`;

const meant = async (link: string) => (await meantBy(link)).fingerprint;

/** In the page: flat views that reach beyond their column. */
const overflow = () => {
	const edge = document.querySelector("panicle-editors")?.getBoundingClientRect().right ?? 0;
	const views = [...document.querySelectorAll(".editor > *")];
	return views.filter((view) => view.getBoundingClientRect().right > edge + 1).map(({ localName }) => localName);
};

/** The smoke set in a browser that `launch` opens on a screen; it saves to the folder. */
export function smoke(name: string, launch: (display: string, downloads: string) => Promise<Driven>): void {
	describe(name, () => {
		let screen: Started & { display: string };
		let host: Host;
		let page: DrivenPage;
		const downloads = home();

		beforeAll(async () => {
			[screen, host] = await Promise.all([startScreen(), startHost()]);
			page = new DrivenPage(await launch(screen.display, downloads));
			console.log(`${page.browser.version}, on a screen that nobody sees`);
		});
		afterEach(async () => expect(await page.complaints(), "what the page complained of").toEqual([]));
		afterAll(async () => {
			await page?.browser.close();
			await Promise.all([screen?.end(), host?.close()]);
			rmSync(downloads, { recursive: true, force: true, maxRetries: 5 });
		});

		it.each(LINKS)("%s grows what it grows in Node, to the bit", async (link) => {
			expect(await page.open(host.app + link)).toBe(await meant(link));
		});

		it("a bunch is drawn by WebGL 2, and flat views beside it in their places", async () => {
			await page.open(`${host.drawn}?v=2&preset=redcurrant`);
			await expect.poll(() => page.ink(), { timeout: 60_000, interval: 250 }).toBeGreaterThan(0.02);
			expect(await page.run(overflow), "flat views beyond their column").toEqual([]);
			expect(await page.run(() => document.querySelector("[role=alert]")?.textContent ?? "")).toBe("");
		});

		it("a slider by keyboard and a handle by pointer regrow; Undo brings back, the link loaded again the same", async () => {
			const first = await page.open(host.app + SMALL);
			await page.regrown(() => page.press(LENGTH, KEYS.PageDown));
			await page.click(named("Undo"));
			await page.shows(first);
			await page.drag(handle("p3"), 40, 12);
			await page.until(() => page.run(() => location.search), /[?&]p3=\d/);
			const link = await page.run(() => location.search);
			// What the hand has passed through comes before it.
			await page.shows(await meant(link));
			expect(await page.open(host.app + link)).toBe(await meant(link));
		});

		it("a preset is opened from the gallery", async () => {
			await page.open(host.app + SMALL);
			await page.click("[data-preset=duku]");
			await page.shows(await meant("?v=2&preset=duku"));
			expect(await page.run(() => location.search)).toBe("?v=2&preset=duku");
		});

		it("a GLB is downloaded that the validator has nothing against", async () => {
			await page.open(host.app + SMALL);
			await page.click(named("Download"));
			await page.click("[data-format=glb]");
			const file = join(downloads, "redcurrant-altered-7.glb");
			// A GLB says how long it is.
			const whole = () => {
				const bytes = existsSync(file) ? readFileSync(file) : Buffer.alloc(0);
				return bytes.length >= 12 && bytes.readUInt32LE(8) === bytes.length;
			};
			await expect.poll(whole, { timeout: 60_000 }).toBe(true);
			const { issues } = await validateBytes(new Uint8Array(readFileSync(file)));
			expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
		});

		it("the element grows in a page of another origin, and is told what to grow", async () => {
			await page.browser.open(`${host.others}element.html`);
			const grown = await page.run(async () => {
				await customElements.whenDefined("panicle-specimen");
				const plant = document.querySelector("panicle-specimen") as PanicleSpecimen;
				await plant.grow();
				const first = plant.plant?.fingerprint;
				await plant.set({ seed: 11 });
				return [first, plant.plant?.fingerprint];
			});
			expect(grown).toEqual([await meant(SMALL), await meant(SMALL.replace("seed=7", "seed=11"))]);
		});

		it("the frame answers a page of another origin", async () => {
			await page.browser.open(`${host.others}frame.html`);
			const answers = await page.run(async (src) => {
				const { origin } = new URL(src);
				const frame = Object.assign(document.createElement("iframe"), { src });
				// Before that nobody hears.
				const loaded = new Promise((resolve) => frame.addEventListener("load", resolve));
				document.body.append(frame);
				await loaded;
				const { contentWindow } = frame;
				const asked = (id: number, method: string, values = {}) =>
					new Promise<{ result?: { fingerprint?: string; seed?: number }; error?: string }>((resolve) => {
						addEventListener("message", ({ data }) => data.id === id && resolve(data));
						contentWindow?.postMessage({ panicle: "panicle/1", id, method, values }, origin);
					});
				return [await asked(1, "set", { seed: 11 }), await asked(2, "specimen")];
			}, `${host.app}embed.html${SMALL}`);
			expect(answers[1]).toMatchObject({ result: { preset: "redcurrant", seed: 11 } });
			expect(answers[0].error).toBeUndefined();
		});
	});
}
