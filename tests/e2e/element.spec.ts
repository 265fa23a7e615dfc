import type { Page } from "@playwright/test";
import type { GrownDetail, PanicleSpecimen } from "../../web/src/element/panicle";
import { expect, test } from "./fixtures";
import { type HostPage, serveUnder } from "./static_server";

/** `<panicle-specimen>` in pages of other origins, as its users have it. */
let library: Awaited<ReturnType<typeof serveUnder>>;
test.beforeAll(async () => {
	library = await serveUnder("/of/panicle/");
});
test.afterAll(() => library.close());

const SMALL = 'preset="redcurrant" count="6"';
const page = (body: string, policy?: string): HostPage => ({
	html: `<!doctype html><html lang="en"><title>Plants</title><link rel="icon" href="data:,"><script type="module" src="${library.address}panicle.js"></script>${body}`,
	...(policy ? { policy } : {}),
});

/** Opens a page of another origin; with `own`, of the library's. */
async function open(browserPage: Page, body: string, policy?: string): Promise<() => Promise<void>> {
	const host = await serveUnder("/none/", "dist", { "plants.html": page(body, policy) });
	await browserPage.goto(new URL("/plants.html", host.address).href);
	return host.close;
}

/** Waits until every plant of the page has grown. */
async function grown(browserPage: Page): Promise<void> {
	await browserPage.waitForFunction(() =>
		[...document.querySelectorAll<PanicleSpecimen>("panicle-specimen")].every(
			(each) => each.plant && !each.hasAttribute("aria-busy"),
		),
	);
}

test("one script and one tag show a plant in a page of another origin, which tells, changes and saves it", async ({
	page,
}) => {
	const close = await open(page, `<panicle-specimen ${SMALL} seed="7" colour="red"></panicle-specimen>`);
	const view = page.getByRole("application", { name: "Redcurrant: 6 berries" });
	await expect(view).toBeVisible();
	await grown(page);
	const told = await page.evaluate(async () => {
		const plant = document.querySelector("panicle-specimen") as PanicleSpecimen;
		const heard: [string, GrownDetail | undefined][] = [];
		for (const type of ["change", "grown", "error"])
			plant.addEventListener(type, (event) => heard.push([type, (event as CustomEvent).detail]));
		const { notes } = plant;
		plant.setAttribute("count", "9");
		await new Promise((resolve) => plant.addEventListener("grown", resolve, { once: true }));
		await plant.set({ seed: 11, age: 50 });
		const [json, glb, png] = [
			await plant.toFile("json"),
			await plant.toFile("glb"),
			await plant.toBlob({ width: 40, height: 60 }),
		];
		const picture = await createImageBitmap(png);
		const document_ = JSON.parse(await json.text());
		const same = document_.fingerprint === plant.plant?.fingerprint;
		const { specimen } = plant;
		const told = heard.map(([type, detail]) => [type, detail?.link, detail?.words]);
		// One change does not undo another that is on its way, nor is one lost that comes while the plant is on no page.
		await Promise.allSettled([plant.set({ seed: 12 }), plant.set({ age: 40 })]);
		const both = plant.specimen;
		plant.remove();
		plant.setAttribute("count", "8");
		document.body.append(plant);
		await plant.grow();
		return {
			notes,
			heard: told,
			specimen,
			both,
			after: plant.specimen,
			magic: await glb.slice(0, 4).text(),
			size: [picture.width, picture.height],
			same,
		};
	});
	expect(told.notes).toEqual(["colour: no parameter of the bunch has that name; it is passed over."]);
	const link = "?v=2&preset=redcurrant&seed=11&count=9&age=50";
	expect(told.heard.map(([type]) => type)).toEqual(["grown", "change", "grown"]);
	expect(told.heard.map(([, link]) => link)).toEqual(["?v=2&preset=redcurrant&seed=7&count=9", link, link]);
	expect(told.heard[0][2]).toMatch(/^9 berries/);
	expect(told.specimen).toMatchObject({ seed: 11, parameters: { age: 50, count: 9 } });
	expect(told.both).toMatchObject({ seed: 12, parameters: { age: 40, count: 9 } });
	expect(told.after).toMatchObject({ seed: 7, parameters: { count: 8 } });
	expect({ ...told, notes: 0, heard: 0, specimen: 0 }).toMatchObject({ magic: "glTF", size: [40, 60], same: true });
	await close();
});

test("it is turned by keys, scrolls with the page, and says what is wrong", async ({ page }) => {
	const close = await open(page, `<panicle-specimen ${SMALL}></panicle-specimen><p style="height: 2000px">`);
	await grown(page);
	const picture = () =>
		page.evaluate(() => {
			const canvas = document.querySelector("panicle-specimen")?.shadowRoot?.querySelector("canvas");
			return canvas?.toDataURL();
		});
	await page.getByRole("application").hover();
	await page.mouse.wheel(0, 120);
	await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(50);
	await page.evaluate(() => scrollTo(0, 0));
	await page.keyboard.press("Tab");
	await expect(page.getByRole("application")).toBeFocused();
	await page.keyboard.press("ArrowLeft");
	expect(await picture()).toMatch(/^data:image\/png/);
	const words = await page.evaluate(async () => {
		const plant = document.querySelector("panicle-specimen") as PanicleSpecimen;
		const failed = new Promise<string>((resolve) =>
			plant.addEventListener("error", (event) => resolve((event as unknown as CustomEvent).detail.message)),
		);
		await plant.set({ grammar: "axiom: F(\n" }).catch(() => {});
		return [await failed, plant.shadowRoot?.querySelector("[part=message]")?.textContent, plant.plant !== undefined];
	});
	expect(words[0]).toBe(words[1]);
	expect(words[0]).toMatch(/value is missing/);
	expect(words[2]).toBe(true);
	await close();
});

test("policies as strict as the app's own let it live", async ({ page }) => {
	const self =
		"default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; style-src 'self'; img-src 'self' data:; connect-src 'self'";
	const body = `<panicle-specimen ${SMALL} poster="/of/panicle/icons/panicle.svg"></panicle-specimen>`;
	const pages: Record<string, HostPage> = {};
	const own = await serveUnder("/of/panicle/", "dist", pages);
	pages["plants.html"] = {
		policy: self,
		html: `<!doctype html><html lang="en"><title>Plants</title><link rel="icon" href="data:,"><script type="module" src="/of/panicle/panicle.js"></script>${body}`,
	};
	await page.goto(new URL("/plants.html", own.address).href);
	await grown(page);
	await page.goto("about:blank");
	await own.close();
	const { origin } = new URL(library.address);
	const least = `default-src 'none'; img-src data:; script-src ${origin} 'wasm-unsafe-eval'; connect-src ${origin}; worker-src blob: ${origin}`;
	const close = await open(page, `<panicle-specimen ${SMALL}></panicle-specimen>`, least);
	await grown(page);
	await close();
});

test("what is off screen grows when it comes near, and turns only where it is seen", async ({ page }) => {
	const close = await open(
		page,
		`<panicle-specimen id="first" ${SMALL} autorotate></panicle-specimen><div style="height: 3000px"></div>
		<panicle-specimen id="second" ${SMALL} loading="lazy"></panicle-specimen>`,
	);
	await page.waitForFunction(() => document.querySelector<PanicleSpecimen>("#first")?.plant);
	const frames = () =>
		page.evaluate(async () => {
			let count = 0;
			const asked = window.requestAnimationFrame;
			window.requestAnimationFrame = (callback) => {
				count++;
				return asked.call(window, callback);
			};
			await new Promise((resolve) => setTimeout(resolve, 600));
			window.requestAnimationFrame = asked;
			return count;
		});
	await expect.poll(frames).toBeGreaterThan(3);
	expect(await page.evaluate(() => document.querySelector<PanicleSpecimen>("#second")?.plant)).toBeUndefined();
	await page.locator("#second").scrollIntoViewIfNeeded();
	await page.waitForFunction(() => document.querySelector<PanicleSpecimen>("#second")?.plant);
	await expect.poll(frames).toBe(0);
	await page.evaluate(() => scrollTo(0, 0));
	await expect.poll(frames).toBeGreaterThan(3);
	await page.emulateMedia({ reducedMotion: "reduce" });
	await expect.poll(frames).toBe(0);
	await close();
});

test("a hundred that come and go leave nothing behind, and ten share a context", async ({ page }) => {
	await page.addInitScript(() => {
		const counts = { workers: 0, contexts: 0, listeners: 0 };
		Object.assign(window, { counts });
		const Plain = window.Worker;
		window.Worker = class extends Plain {
			#ended = false;
			constructor(...all: ConstructorParameters<typeof Worker>) {
				super(...all);
				counts.workers++;
			}
			override terminate() {
				if (!this.#ended) counts.workers--;
				this.#ended = true;
				super.terminate();
			}
		};
		const { getContext } = HTMLCanvasElement.prototype;
		const known = new WeakSet<object>();
		HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...all: unknown[]) {
			const context = Reflect.apply(getContext, this, all);
			if (all[0] === "webgl2" && context && !known.has(context)) {
				known.add(context);
				counts.contexts++;
				const lose = context.getExtension.bind(context);
				context.getExtension = (name: string) => {
					const extension = lose(name);
					if (name !== "WEBGL_lose_context" || !extension) return extension;
					return {
						restoreContext: () => extension.restoreContext(),
						loseContext: () => {
							counts.contexts--;
							extension.loseContext();
						},
					};
				};
			}
			return context;
		} as typeof getContext;
		for (const lasting of [window, document, MediaQueryList.prototype]) {
			const { addEventListener } = lasting;
			lasting.addEventListener = function (this: EventTarget, ...all: Parameters<typeof addEventListener>) {
				const [, , options] = all;
				const signal = typeof options === "object" ? options?.signal : undefined;
				if (signal) {
					counts.listeners++;
					signal.addEventListener("abort", () => counts.listeners--);
				}
				return Reflect.apply(addEventListener, this, all);
			} as typeof addEventListener;
		}
	});
	const close = await open(page, "<main></main>");
	const cycles = (count: number) =>
		page.evaluate(async (times) => {
			await customElements.whenDefined("panicle-specimen");
			const main = document.querySelector("main") as HTMLElement;
			for (let i = 0; i < times; i++) {
				const plant = document.createElement("panicle-specimen") as PanicleSpecimen;
				plant.setAttribute("preset", "redcurrant");
				plant.setAttribute("count", "6");
				plant.setAttribute("seed", `${i}`);
				main.append(plant);
				await plant.grow();
				if (i % 3 === 0) plant.resetView();
				plant.remove();
			}
		}, count);
	/** After what lingers has gone. */
	const left = async () => {
		await page.waitForTimeout(1500);
		const session = await page.context().newCDPSession(page);
		await session.send("HeapProfiler.collectGarbage");
		const { usedSize } = await session.send("Runtime.getHeapUsage");
		await session.detach();
		return { heap: usedSize, counts: await page.evaluate(() => (window as unknown as { counts: object }).counts) };
	};
	// Until what a browser makes of code that runs often is there, too.
	await cycles(60);
	const before = await left();
	await cycles(100);
	const after = await left();
	expect(before.counts).toEqual({ workers: 0, contexts: 0, listeners: 0 });
	expect(after.counts).toEqual(before.counts);
	expect(after.heap / before.heap).toBeLessThan(1.05);
	await page.evaluate((plant) => {
		(document.querySelector("main") as HTMLElement).innerHTML = plant.repeat(10);
	}, `<panicle-specimen style="width: 90px; height: 120px" autorotate ${SMALL}></panicle-specimen>`);
	await grown(page);
	expect(await page.evaluate(() => (window as unknown as { counts: object }).counts)).toMatchObject({ contexts: 1 });
	await close();
});

test("a frame holds a plant, and talks with its page alone", async ({ page }) => {
	const close = await open(
		page,
		`<iframe title="A plant" src="${library.address}embed.html?v=2&preset=redcurrant&count=6&theme=dark" width="200" height="300"></iframe>`,
	);
	const view = page.frameLocator("iframe").getByRole("application", { name: "Redcurrant: 6 berries" });
	await expect(view).toBeVisible();
	expect(await view.evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight])).toEqual([200, 300]);
	const told = await page.evaluate(async () => {
		const frame = (document.querySelector("iframe") as HTMLIFrameElement).contentWindow as Window;
		const heard: { id?: number; event?: string; result?: unknown; error?: string; detail?: { words: string } }[] = [];
		addEventListener("message", ({ data }) => heard.push(data));
		const asked = (id: number, method: string, values?: object) =>
			new Promise<(typeof heard)[number]>((resolve) => {
				const wait = () => {
					const answer = heard.find((each) => each.id === id);
					if (answer) resolve(answer);
					else setTimeout(wait, 20);
				};
				frame.postMessage({ panicle: "panicle/1", id, method, values }, "*");
				wait();
			});
		await asked(1, "listen");
		await asked(2, "set", { count: 9 });
		await asked(3, "open", { link: "?v=2&preset=redcurrant&count=7" });
		const { result: file } = await asked(4, "file", { format: "json" });
		const { error } = await asked(5, "dance");
		return {
			events: heard.filter(({ event }) => event).map(({ event, detail }) => [event, detail?.words]),
			file: JSON.parse(await (file as Blob).text()).counts,
			error,
		};
	});
	expect(told.events).toEqual([
		["change", undefined],
		["grown", expect.stringMatching(/^9 berries/)],
		["grown", expect.stringMatching(/^7 berries/)],
	]);
	expect(told.file).toMatchObject({ berries: 7 });
	expect(told.error).toMatch(/^there is no method "dance"/);
	await close();
});
