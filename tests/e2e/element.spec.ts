import type { Page } from "@playwright/test";
import type { GrownDetail, PanicleSpecimen } from "../../web/src/element/panicle";
import { grown, openHost, SMALL, serveLibrary } from "./element_page";
import { expect, test } from "./fixtures";
import { framesRequested } from "./frames";
import { type HostPage, serveUnder } from "./static_server";

let library: Awaited<ReturnType<typeof serveLibrary>>;
test.beforeAll(async () => {
	library = await serveLibrary();
});
test.afterAll(() => library.close());
const open = (page: Page, body: string, policy?: string) => openHost(page, library.address, body, policy);

test("one script and one tag show a plant in a page of another origin, which tells, changes and saves it", async ({
	page,
}) => {
	const close = await open(page, `<panicle-specimen ${SMALL} seed="7" colour="red"></panicle-specimen>`);
	const view = page.getByRole("application", { name: /^Redcurrant bunch: .+ with 6 berries$/ });
	await expect(view).toBeVisible();
	await grown(page);
	const result = await page.evaluate(async () => {
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
		const result = heard.map(([type, detail]) => [type, detail?.link, detail?.words]);
		// One change does not undo another that is on its way, nor is one lost that comes while the plant is on no page.
		await Promise.allSettled([plant.set({ seed: 12 }), plant.set({ age: 40 })]);
		const both = plant.specimen;
		plant.remove();
		plant.setAttribute("count", "8");
		document.body.append(plant);
		await plant.grow();
		return {
			notes,
			heard: result,
			specimen,
			both,
			after: plant.specimen,
			magic: await glb.slice(0, 4).text(),
			size: [picture.width, picture.height],
			same,
		};
	});
	expect(result.notes).toEqual(["colour: The model bunch has no such parameter. The attribute was ignored."]);
	const link = "?v=2&preset=redcurrant&seed=11&count=9&age=50";
	expect(result.heard.map(([type]) => type)).toEqual(["grown", "change", "grown"]);
	expect(result.heard.map(([, link]) => link)).toEqual(["?v=2&preset=redcurrant&seed=7&count=9", link, link]);
	expect(result.heard[0][2]).toMatch(/ with 9 berries$/);
	expect(result.specimen).toMatchObject({ seed: 11, parameters: { age: 50, count: 9 } });
	expect(result.both).toMatchObject({ seed: 12, parameters: { age: 40, count: 9 } });
	expect(result.after).toMatchObject({ seed: 7, parameters: { count: 8 } });
	expect({ ...result, notes: 0, heard: 0, specimen: 0 }).toMatchObject({ magic: "glTF", size: [40, 60], same: true });
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

test("what is off screen grows when it comes near, and turns only where it is seen", { tag: "@long" }, async ({
	page,
}) => {
	const close = await open(
		page,
		`<panicle-specimen id="first" ${SMALL} autorotate></panicle-specimen><div style="height: 3000px"></div>
		<panicle-specimen id="second" ${SMALL} loading="lazy"></panicle-specimen>`,
	);
	await page.waitForFunction(() => document.querySelector<PanicleSpecimen>("#first")?.plant);
	const frames = () => framesRequested(page);
	await expect.poll(frames).toBeGreaterThan(3);
	expect(await page.evaluate(() => document.querySelector<PanicleSpecimen>("#second")?.plant)).toBeUndefined();
	await page.locator("#second").scrollIntoViewIfNeeded();
	await page.waitForFunction(() => document.querySelector<PanicleSpecimen>("#second")?.plant);
	await expect.poll(frames).toBe(0);
	await page.evaluate(() => scrollTo(0, 0));
	await expect.poll(frames).toBeGreaterThan(3);
	await page.emulateMedia({ reducedMotion: "reduce" });
	await expect.poll(frames).toBe(0);
	await test.step("and sways in the wind likewise", async () => {
		const attributes = (from: string, to: string) =>
			page.locator("#first").evaluate(
				(element, names) => {
					element.removeAttribute(names[0]);
					element.setAttribute(names[1], "");
				},
				[from, to],
			);
		await attributes("autorotate", "wind");
		await expect.poll(frames).toBe(0);
		await page.emulateMedia({ reducedMotion: "no-preference" });
		await expect.poll(frames).toBeGreaterThan(3);
		await page.locator("#second").scrollIntoViewIfNeeded();
		await expect.poll(frames).toBe(0);
		await page.evaluate(() => scrollTo(0, 0));
		await expect.poll(frames).toBeGreaterThan(3);
		await test.step("until its reader pauses it", async () => {
			const pause = page.getByRole("button", { name: "Pause the wind" });
			await page.getByRole("application").first().focus();
			await page.keyboard.press("Tab");
			await expect(pause).toBeFocused();
			await page.keyboard.press("Space");
			await expect(pause).toHaveAttribute("aria-pressed", "true");
			await expect.poll(frames).toBe(0);
			await pause.click();
			await expect.poll(frames).toBeGreaterThan(3);
			await page.emulateMedia({ reducedMotion: "reduce" });
			await expect(pause).toHaveCount(0);
			await page.emulateMedia({ reducedMotion: "no-preference" });
			await pause.click();
		});
		await attributes("wind", "alt");
		await expect(page.getByRole("button", { name: "Pause the wind" })).toHaveCount(0);
		await expect.poll(frames).toBe(0);
	});
	await close();
});

test("a frame holds a plant, and talks with its page alone", async ({ page }) => {
	const close = await open(
		page,
		`<iframe title="A plant" src="${library.address}embed.html?v=2&preset=redcurrant&count=6&theme=dark" width="200" height="300"></iframe>`,
	);
	const view = page.frameLocator("iframe").getByRole("application", { name: /^Redcurrant bunch: .+ with 6 berries$/ });
	await expect(view).toBeVisible();
	expect(await view.evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight])).toEqual([200, 300]);
	const result = await page.evaluate(async () => {
		const frame = (document.querySelector("iframe") as HTMLIFrameElement).contentWindow as Window;
		const heard: { id?: number; event?: string; result?: unknown; error?: string; detail?: { words: string } }[] = [];
		addEventListener("message", ({ data }) => heard.push(data));
		const call = (id: number, method: string, values?: object) =>
			new Promise<(typeof heard)[number]>((resolve) => {
				const wait = () => {
					const answer = heard.find((each) => each.id === id);
					if (answer) resolve(answer);
					else setTimeout(wait, 20);
				};
				frame.postMessage({ panicle: "panicle/1", id, method, values }, "*");
				wait();
			});
		await call(1, "listen");
		await call(2, "set", { count: 9 });
		await call(3, "open", { link: "?v=2&preset=redcurrant&count=7" });
		const { result: file } = await call(4, "file", { format: "json" });
		const { error } = await call(5, "dance");
		const { error: unknown } = await call(6, "file", { format: "dwg" });
		await call(7, "open", { link: "?v=2&model=leaf&preset=birch&n=200" });
		await call(8, "open", { link: "?v=2&model=root&preset=carrot&n=60" });
		await call(9, "open", { link: "?v=2&model=flower&preset=crocus" });
		return {
			// The first plant may have grown after the page began to listen.
			events: heard
				.filter(({ event, detail }) => event && !detail?.words?.endsWith(" 6 berries"))
				.map(({ event, detail }) => [event, detail?.words]),
			file: JSON.parse(await (file as Blob).text()).counts,
			error,
			unknown,
		};
	});
	expect(result.events).toEqual([
		["change", undefined],
		["grown", expect.stringMatching(/ with 9 berries$/)],
		["grown", expect.stringMatching(/ with 7 berries$/)],
		["grown", expect.stringMatching(/^Birch leaf, /)],
		["grown", expect.stringMatching(/ deep, 60 root tips$/)],
		["grown", expect.stringMatching(/ volumes$/)],
	]);
	expect(result.file).toMatchObject({ berries: 7 });
	expect(result.unknown).toMatch(/dwg/);
	expect(result.error).toMatch(/^There is no method "dance"/);
	await close();
});
