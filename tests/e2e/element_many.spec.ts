import type { Page } from "@playwright/test";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { grown, openHost, SMALL, serveLibrary } from "./element_page";
import { expect, test } from "./fixtures";

let library: Awaited<ReturnType<typeof serveLibrary>>;
test.beforeAll(async () => {
	library = await serveLibrary();
});
test.afterAll(() => library.close());
const open = (page: Page, body: string, policy?: string) => openHost(page, library.address, body, policy);

test("a hundred that come and go leave nothing behind, and ten share a context", { tag: "@long" }, async ({ page }) => {
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
				for (const extra of ["controls", "handles"]) plant.toggleAttribute(extra, i % 2 === 0);
				main.append(plant);
				await plant.grow();
				if (i % 3 === 0) plant.resetView();
				plant.remove();
			}
		}, count);
	const countsOf = () => page.evaluate(() => (window as unknown as { counts: object }).counts);
	/** Resources after the workers have ended, which happens a moment after the last plant is gone. */
	const left = async () => {
		await expect.poll(countsOf).toEqual({ workers: 0, contexts: 0, listeners: 0 });
		const session = await page.context().newCDPSession(page);
		await session.send("HeapProfiler.collectGarbage");
		const { usedSize } = await session.send("Runtime.getHeapUsage");
		await session.detach();
		return { heap: usedSize, counts: await countsOf() };
	};
	// Enough cycles for the browser to compile frequently run code.
	await cycles(60);
	const before = await left();
	await cycles(100);
	const after = await left();
	expect(after.counts).toEqual(before.counts);
	expect(after.heap / before.heap).toBeLessThan(1.05);
	await page.evaluate((plant) => {
		(document.querySelector("main") as HTMLElement).innerHTML = plant.repeat(10);
	}, `<panicle-specimen style="width: 90px; height: 120px" autorotate ${SMALL}></panicle-specimen>`);
	await grown(page);
	expect(await countsOf()).toMatchObject({ contexts: 1 });
	await close();
});

test("ten visible ones are turned on one context that is not lost, and what comes and goes beside them leaves nothing on the card", {
	tag: "@long",
}, async ({ page }) => {
	await page.addInitScript(() => {
		const counts = { Buffer: 0, Texture: 0, Program: 0, Shader: 0, Framebuffer: 0, Renderbuffer: 0, VertexArray: 0 };
		const seen = { lost: 0, draws: 0, counts };
		Object.assign(window, { seen });
		const { prototype } = WebGL2RenderingContext;
		for (const kind of Object.keys(counts) as (keyof typeof counts)[]) {
			const [create, remove] = [`create${kind}`, `delete${kind}`] as ["createBuffer", "deleteBuffer"];
			const [made, gone] = [prototype[create], prototype[remove]];
			prototype[create] = function (this: WebGL2RenderingContext, ...all: []) {
				counts[kind]++;
				return Reflect.apply(made, this, all);
			};
			prototype[remove] = function (this: WebGL2RenderingContext, what) {
				if (what) counts[kind]--;
				Reflect.apply(gone, this, [what]);
			};
		}
		for (const type of ["drawElements", "drawElementsInstanced", "drawArrays"] as const) {
			const draw = prototype[type] as () => void;
			Object.assign(prototype, {
				[type](this: WebGL2RenderingContext, ...all: unknown[]) {
					seen.draws++;
					Reflect.apply(draw, this, all);
				},
			});
		}
		for (const canvas of [HTMLCanvasElement.prototype, OffscreenCanvas.prototype]) {
			const { getContext } = canvas;
			Object.assign(canvas, {
				getContext(this: HTMLCanvasElement, ...all: unknown[]) {
					this.addEventListener("webglcontextlost", () => seen.lost++);
					return Reflect.apply(getContext, this, all);
				},
			});
		}
	});
	const plant = `<panicle-specimen style="width: 90px; height: 120px" ${SMALL}></panicle-specimen>`;
	const close = await open(page, `<main>${plant.repeat(10)}</main><aside></aside>`);
	await grown(page);
	const seen = () =>
		page.evaluate(() => (window as unknown as { seen: { lost: number; draws: number; counts: object } }).seen);
	const cycles = (count: number) =>
		page.evaluate(async (times) => {
			for (let i = 0; i < times; i++) {
				const plant = document.createElement("panicle-specimen") as PanicleSpecimen;
				for (const [name, value] of Object.entries({ preset: "redcurrant", count: "6", seed: `${i}`, handles: "" }))
					plant.setAttribute(name, value);
				document.querySelector("aside")?.append(plant);
				await plant.toBlob({ width: 30, height: 40 });
				plant.remove();
			}
		}, count);
	await cycles(3);
	const before = await seen();
	await cycles(10);
	await page.evaluate(async () => {
		const step = () => new Promise(requestAnimationFrame);
		for (let i = 0; i < 12; i++) {
			for (const { shadowRoot } of document.querySelectorAll("panicle-specimen"))
				shadowRoot
					?.querySelector("canvas")
					?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
			await step();
		}
		await step();
	});
	const after = await seen();
	expect(after.draws - before.draws).toBeGreaterThan(10 * 12);
	// A context that only tests for graphics support is released at once.
	expect(after.lost).toBe(before.lost);
	expect(after.counts).toEqual(before.counts);
	await close();
});
