/**
 * The tests that every browser passes. The gate runs one of them, the smoke test; the long run runs all.
 */
import { existsSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { validateBytes } from "gltf-validator";
import { afterAll, afterEach, beforeAll, describe, expect, it } from "vitest";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { meantBy } from "../golden/links/list";
import { isLongRun } from "../long_run.mjs";
import { type Driven, home } from "./driven";
import { DrivenPage, KEYS } from "./driven_page";
import { type Host, startHost } from "./host";
import { type Started, startScreen } from "./processes";

/** One link of each model, and of both procedures of the bunch; few particles, since the view is drawn by software. */
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

/** In the page: the flat views that extend beyond their column. */
const overflow = () => {
	const edge = document.querySelector("panicle-editors")?.getBoundingClientRect().right ?? 0;
	const views = [...document.querySelectorAll(".editor > *")];
	return views.filter((view) => view.getBoundingClientRect().right > edge + 1).map(({ localName }) => localName);
};

/** In the page: the text of the alert, if there is one. */
const alert = () => document.querySelector("[role=alert]")?.textContent ?? "";

/** Defines the tests for one browser. `launch` opens it on a screen; it downloads to the given folder. */
export function smoke(name: string, launch: (display: string, downloads: string) => Promise<Driven>): void {
	describe(name, () => {
		let screen: Started & { display: string };
		let host: Host;
		let page: DrivenPage;
		const downloads = home();

		beforeAll(async () => {
			[screen, host] = await Promise.all([startScreen(), startHost()]);
			page = new DrivenPage(await launch(screen.display, downloads));
			console.log(`${page.browser.version}, on a virtual screen`);
		});
		afterEach(async () => expect(await page.complaints(), "errors that the page reported").toEqual([]));
		afterAll(async () => {
			await page?.browser.close();
			await Promise.all([screen?.end(), host?.close()]);
			rmSync(downloads, { recursive: true, force: true, maxRetries: 5 });
		});

		/** Downloads the GLB of the plant that is shown. */
		async function downloadGlb(name: string): Promise<Uint8Array> {
			await page.click(named("Download"));
			await page.click("[data-format=glb]");
			const file = join(downloads, name);
			// The header of a GLB has the length of the file.
			const isComplete = () => {
				const bytes = existsSync(file) ? readFileSync(file) : Buffer.alloc(0);
				return bytes.length >= 12 && bytes.readUInt32LE(8) === bytes.length;
			};
			await expect.poll(isComplete, { timeout: 60_000 }).toBe(true);
			return new Uint8Array(readFileSync(file));
		}

		it("draws a bunch by WebGL 2, the same as Node to the bit, regrows it by a slider and exports a valid GLB", async () => {
			expect(await page.open(host.drawn + SMALL)).toBe(await meant(SMALL));
			await expect.poll(() => page.ink(), { timeout: 60_000, interval: 250 }).toBeGreaterThan(0.01);
			expect(await page.run(overflow), "flat views beyond their column").toEqual([]);
			expect(await page.run(alert)).toBe("");
			await page.regrown(() => page.press(LENGTH, KEYS.PageDown));
			const { issues } = await validateBytes(await downloadGlb("redcurrant-altered-7.glb"));
			expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
		});

		const long = it.runIf(isLongRun);

		long.each(LINKS)("%s grows the same as in Node, to the bit", async (link) => {
			expect(await page.open(host.app + link)).toBe(await meant(link));
		});

		long("draws a larger bunch by WebGL 2", async () => {
			await page.open(`${host.drawn}?v=2&preset=redcurrant`);
			await expect.poll(() => page.ink(), { timeout: 60_000, interval: 250 }).toBeGreaterThan(0.02);
			expect(await page.run(overflow), "flat views beyond their column").toEqual([]);
			expect(await page.run(alert)).toBe("");
		});

		long("regrows by a slider and by a handle, undoes, and grows the same from its link", async () => {
			const first = await page.open(host.app + SMALL);
			await page.regrown(() => page.press(LENGTH, KEYS.PageDown));
			await page.click(named("Undo"));
			await page.shows(first);
			await page.drag(handle("p3"), 40, 12);
			await page.until(() => page.run(() => location.search), /[?&]p3=\d/);
			const link = await page.run(() => location.search);
			// The plants of the drag's intermediate positions come first.
			await page.shows(await meant(link));
			expect(await page.open(host.app + link)).toBe(await meant(link));
		});

		long("opens a preset from the gallery", async () => {
			await page.open(host.app + SMALL);
			await page.click("[data-preset=duku]");
			await page.shows(await meant("?v=2&preset=duku"));
			expect(await page.run(() => location.search)).toBe("?v=2&preset=duku");
		});

		long("grows the element in a page of another origin, and again when a parameter is set", async () => {
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

		long("answers messages of another origin in the frame", async () => {
			await page.browser.open(`${host.others}frame.html`);
			const answers = await page.run(async (src) => {
				const { origin } = new URL(src);
				const frame = Object.assign(document.createElement("iframe"), { src });
				// Messages before the load are lost.
				const loaded = new Promise((resolve) => frame.addEventListener("load", resolve));
				document.body.append(frame);
				await loaded;
				const { contentWindow } = frame;
				const send = (id: number, method: string, values = {}) =>
					new Promise<{ result?: { fingerprint?: string; seed?: number }; error?: string }>((resolve) => {
						addEventListener("message", ({ data }) => data.id === id && resolve(data));
						contentWindow?.postMessage({ panicle: "panicle/1", id, method, values }, origin);
					});
				return [await send(1, "set", { seed: 11 }), await send(2, "specimen")];
			}, `${host.app}embed.html${SMALL}`);
			expect(answers[1]).toMatchObject({ result: { preset: "redcurrant", seed: 11 } });
			expect(answers[0].error).toBeUndefined();
		});
	});
}
