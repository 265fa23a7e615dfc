import { expect, test } from "./fixtures";
import { openViews, serveViews } from "./views_page";

test.use({ drawn: true });

/** Graphics contexts that views use and release. Browsers keep about sixteen contexts, and drop the oldest beyond. */
let host: Awaited<ReturnType<typeof serveViews>>;
test.beforeAll(async () => {
	host = await serveViews();
});
test.afterAll(() => host.close());
test.beforeEach(({ page }) => openViews(page, host.address));

const SMALL = "?v=2&preset=redcurrant&count=6";

test("twenty views made and disposed leave nothing behind", { tag: "@long" }, async ({ page }) => {
	const warnings: string[] = [];
	page.on("console", (message) => warnings.push(message.text()));
	const left = await page.evaluate(async (query) => {
		const { view } = window.views;
		const remaining = view(query, [48, 48]);
		await remaining.whenIdle();
		const gl = document.querySelector("canvas")?.getContext("webgl2");
		// Listeners on objects that outlive a view.
		const listening = new Set<string>();
		const numbers = new Map<unknown, number>();
		for (const lasting of [window, document]) {
			const { addEventListener, removeEventListener } = lasting;
			const named = ([type, listener]: unknown[]) => {
				numbers.set(listener, numbers.get(listener) ?? numbers.size);
				return `${lasting === window ? "window" : "document"} ${type} ${numbers.get(listener)}`;
			};
			lasting.addEventListener = (...all: unknown[]) => {
				listening.add(named(all));
				return Reflect.apply(addEventListener, lasting, all);
			};
			lasting.removeEventListener = (...all: unknown[]) => {
				listening.delete(named(all));
				return Reflect.apply(removeEventListener, lasting, all);
			};
		}
		const frames: number[] = [];
		const contexts = [];
		for (let i = 0; i < 20; i++) {
			const viewer = view(query, [48, 48], { still: i % 2 === 0 });
			const canvas = [...document.querySelectorAll("canvas")].at(-1) as HTMLCanvasElement;
			await viewer.whenIdle();
			viewer.orbit(0.1, 0);
			viewer.dispose();
			frames.push(viewer.rendersCount);
			contexts.push({ viewer, lost: canvas.getContext("webgl2")?.isContextLost() });
			canvas.remove();
		}
		for (let i = 0; i < 30; i++) await new Promise(requestAnimationFrame);
		return {
			firstLost: gl?.isContextLost(),
			lost: contexts.map(({ lost }) => lost),
			drawnSince: contexts.map(({ viewer }, i) => viewer.rendersCount - frames[i]),
			listening: [...listening],
		};
	}, SMALL);
	expect(left).toEqual({
		firstLost: false,
		lost: new Array(20).fill(true),
		drawnSince: new Array(20).fill(0),
		listening: [],
	});
	expect(warnings.filter((text) => /context/i.test(text))).toEqual([]);
});

test("twenty views share one context, and each shows its own plant at its own size", { tag: "@long" }, async ({
	page,
}) => {
	const seen = await page.evaluate(async () => {
		const { canvas, grow, pixels, Renderer, Viewer, bunchRenderer } = window.views;
		const original = HTMLCanvasElement.prototype.getContext;
		let contexts = 0;
		HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...all: unknown[]) {
			if (all[0] === "webgl2") contexts++;
			return Reflect.apply(original, this, all);
		} as typeof original;
		const renderer = new Renderer(undefined, true);
		const making = contexts;
		const hues = ["40d040", "d04040"];
		const views = Array.from({ length: 20 }, (_, i) => {
			const shown = canvas(40 + 2 * i, 60);
			const viewer = new Viewer<never, never>(shown, { still: true, reducedMotion: true, renderer });
			viewer.use(bunchRenderer as never);
			const skin = hues[i % 2];
			const { grown, specimen } = grow(`?v=2&preset=redcurrant&count=8&skin=${skin}&unripe=${skin}&bloom=0`);
			viewer.show(grown as never, specimen as never);
			return { viewer, shown };
		});
		for (const { viewer } of views) await viewer.whenIdle();
		const looks = [];
		for (const { shown } of views) {
			const blob = await new Promise<Blob | null>((resolve) => shown.toBlob(resolve));
			const { data, width, height } = await pixels(blob as Blob);
			let [red, green] = [0, 0];
			for (let at = 0; at < data.length; at += 4) {
				if (data[at] > 1.3 * data[at + 1]) red++;
				if (data[at + 1] > 1.15 * data[at]) green++;
			}
			looks.push({ width, height, red: red > 3 * green && red > 20, green: green > 3 * red && green > 20 });
		}
		const held = renderer.held;
		for (const { viewer } of views) viewer.dispose();
		const after = renderer.held;
		const lost = renderer.lost;
		renderer.dispose();
		return { contexts: contexts - making, looks, held, after, lost };
	});
	expect(seen.contexts).toBe(0);
	expect(seen.looks).toEqual(
		Array.from({ length: 20 }, (_, i) => ({ width: 40 + 2 * i, height: 60, red: i % 2 === 1, green: i % 2 === 0 })),
	);
	expect(seen.held.geometries).toBeGreaterThan(60);
	expect(seen.after.geometries).toBeLessThan(4);
	expect(seen.lost).toBe(false);
});
