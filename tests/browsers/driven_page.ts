/** The app in a controlled browser, as a user sees and operates it. */
import { expect } from "vitest";
import type { Device, Driven } from "./driven";

/** Keys that have no letter, as WebDriver writes them. */
export const KEYS = { PageDown: "\uE00F", ArrowLeft: "\uE012" } as const;

/** Timeout and interval of waits, milliseconds. */
const PATIENCE = { timeout: 60_000, interval: 50 };

interface Point {
	readonly x: number;
	readonly y: number;
}

export class DrivenPage {
	constructor(readonly browser: Driven) {}

	/** Runs a function in the page; it cannot use variables of this file. */
	run<Result, Arguments extends readonly unknown[]>(
		work: (...args: Arguments) => Result | Promise<Result>,
		...args: Arguments
	): Promise<Result> {
		return this.browser.evaluate(`(${work})(...${JSON.stringify(args)})`) as Promise<Result>;
	}

	/** Opens the app at a link and waits for its plant. */
	async open(address: string): Promise<string> {
		await this.browser.open(address);
		await this.until(() => this.fingerprint(), /^[0-9a-f]{16}$/);
		return this.fingerprint();
	}

	fingerprint(): Promise<string> {
		return this.run(() => document.querySelector<HTMLElement>("[data-fingerprint]")?.innerText ?? "");
	}

	/** Waits until a query's result matches a pattern. */
	until<Value extends string>(query: () => Promise<Value>, pattern: RegExp): Promise<void> {
		return expect.poll(query, PATIENCE).toMatch(pattern);
	}

	/** Does something and waits for the plant that follows from it. */
	async regrown(action: () => Promise<unknown>): Promise<string> {
		const before = await this.fingerprint();
		await action();
		await expect.poll(() => this.fingerprint(), PATIENCE).not.toBe(before);
		return this.fingerprint();
	}

	/** Waits until a plant is shown that is known. */
	shows(fingerprint: string): Promise<void> {
		return expect.poll(() => this.fingerprint(), PATIENCE).toBe(fingerprint);
	}

	/** The middle of the first thing that fits, brought into sight, once it is there and stands still. */
	async middle(selector: string): Promise<Point> {
		const at = () =>
			this.run(async (path) => {
				const [outer, inner] = path.split(" >>> ");
				const host = document.querySelector(outer);
				const found = inner ? host?.shadowRoot?.querySelector(inner) : host;
				if (!found) return null;
				found.scrollIntoView({ block: "nearest", inline: "nearest" });
				await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
				const { x, y, width, height } = found.getBoundingClientRect();
				return { x: Math.round(x + width / 2), y: Math.round(y + height / 2) };
			}, selector);
		let before: Point | null = null;
		let point: Point | null = null;
		const stands = async () => {
			before = point;
			point = await at();
			return point !== null && point.x === before?.x && point.y === before.y;
		};
		await expect.poll(stands, { ...PATIENCE, message: selector }).toBe(true);
		return point as unknown as Point;
	}

	/** Presses a button that the mouse goes to. */
	async click(selector: string): Promise<void> {
		await this.#mouse([...move(await this.middle(selector)), { type: "pointerDown", button: 0 }, RELEASE]);
	}

	/** Takes hold of something by the mouse, and lets go of it so many pixels away. */
	async drag(selector: string, right: number, down: number): Promise<void> {
		const { x, y } = await this.middle(selector);
		const steps = Array.from({ length: 8 }, (_, i) => (i + 1) / 8);
		const way = steps.flatMap((part) => move({ x: Math.round(x + part * right), y: Math.round(y + part * down) }));
		await this.#mouse([...move({ x, y }), { type: "pointerDown", button: 0 }, ...way, RELEASE]);
	}

	/** Gives something the focus and presses a key. */
	async press(selector: string, key: string): Promise<void> {
		await this.run((css) => document.querySelector<HTMLElement>(css)?.focus(), selector);
		const actions = [
			{ type: "keyDown", value: key },
			{ type: "keyUp", value: key },
		];
		await this.browser.act([{ type: "key", id: "keyboard", actions }]);
	}

	#mouse(actions: Device["actions"]): Promise<void> {
		return this.browser.act([{ type: "pointer", id: "mouse", actions }]);
	}

	/** The share of the 3-D view's pixels that are dark, as on the light paper plants are alone. */
	async ink(): Promise<number> {
		const picture = (await this.browser.picture()).toString("base64");
		return this.run(async (base64) => {
			const bytes = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0));
			const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
			const box = document.querySelector("canvas.stage-surface")?.getBoundingClientRect() ?? new DOMRect();
			const canvas = Object.assign(document.createElement("canvas"), { width: box.width, height: box.height });
			const context = canvas.getContext("2d") as CanvasRenderingContext2D;
			context.drawImage(image, -box.x, -box.y);
			const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
			let dark = 0;
			for (let at = 0; at < data.length; at += 4) if (data[at] + data[at + 1] + data[at + 2] < 360) dark++;
			return dark / (data.length / 4);
		}, picture);
	}

	/** Errors of the page and the browser since the page was opened. */
	async complaints(): Promise<string[]> {
		const own = await this.run(
			() => (globalThis as unknown as { complaints?: string[] }).complaints ?? ["no listener"],
		);
		return [...own, ...this.browser.complaints()];
	}
}

const move = ({ x, y }: Point) => [{ type: "pointerMove", x, y, duration: 0 }];
const RELEASE = { type: "pointerUp", button: 0 };
