import { expect, type Locator, type Page } from "@playwright/test";

/** The page as a person finds it: by the names of its parts. */
export class StudioPage {
	constructor(readonly page: Page) {}

	/** Opens the app and waits for the first bunch. */
	async open(search = "?v=2"): Promise<this> {
		await this.page.goto(`./${search}`);
		await expect(this.fingerprint).toHaveText(/^[0-9a-f]{16}$/);
		return this;
	}

	/** Waits until the plant stands in the 3-D view, where it can be pointed at. */
	async stands(): Promise<void> {
		await this.page.waitForFunction(() => performance.getEntriesByName("first-bunch").length > 0);
	}

	/** Waits until the presets of all models are in the gallery. */
	async presetsListed(): Promise<void> {
		await expect(this.page.locator("panicle-gallery[data-models='8']")).toBeAttached();
	}

	/** Opens the gallery of presets. @returns the dialog */
	async browse(): Promise<Locator> {
		await this.presetsListed();
		await this.page.getByRole("button", { name: "Browse presets" }).click();
		const dialog = this.page.getByRole("dialog", { name: "Presets" });
		await expect(dialog).toBeVisible();
		return dialog;
	}

	/** Chooses a preset of any family in the gallery of presets. */
	async choosePreset(model: string, preset: string): Promise<void> {
		const dialog = await this.browse();
		await dialog.getByRole("button", { name: "All", exact: true }).click();
		const papers = dialog.getByText("From research papers");
		if (!(await dialog.locator(`section[data-model=${model}] [data-preset=${preset}]`).isVisible()))
			await papers.click();
		await dialog.locator(`section[data-model=${model}] [data-preset=${preset}]`).click();
		await expect(dialog).toBeHidden();
	}

	get fingerprint(): Locator {
		return this.page.locator("[data-fingerprint]");
	}

	get canvas(): Locator {
		return this.page.getByRole("application", { name: /^Grape bunch/ });
	}

	get notices(): Locator {
		return this.page.locator("panicle-notices");
	}

	/** A line of the read-out, by its words. */
	readout(words: string): Locator {
		return this.page.locator(".readout dt", { hasText: new RegExp(`^${words}`) }).locator("+ dd");
	}

	/** A measure of the read-out, by its key. */
	measure(key: string): Locator {
		return this.page.locator(`[data-measure=${key}]`);
	}

	/** How many berries are not there for one reason. */
	missing(why: string): Locator {
		return this.page.locator(`[data-why="${why}"]`);
	}

	slider(name: string): Locator {
		return this.page.getByRole("slider", { name, exact: true });
	}

	button(name: string): Locator {
		return this.page.getByRole("button", { name, exact: true });
	}

	handle(view: string, handle: string): Locator {
		return this.page.getByRole("region", { name: `${view} view` }).locator(`[data-handle="${handle}"]`);
	}

	/** Where to take hold of a handle, in pixels of the page, once it stands still. */
	async grip(view: string, handle: string): Promise<{ x: number; y: number }> {
		const centre = async () => {
			const box = await this.handle(view, handle).boundingBox();
			if (!box) throw new Error(`Handle ${handle} is not on the page.`);
			return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
		};
		let at = await centre();
		await expect(async () => {
			const before = at;
			await this.page.evaluate(
				() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
			);
			at = await centre();
			expect(at).toEqual(before);
		}).toPass();
		return at;
	}

	/** Opens a group of the panel by its title, and the disclosure "Advanced" if the group is in it. */
	async openGroup(title: string): Promise<void> {
		const heading = this.page.locator(".group > summary").filter({ hasText: new RegExp(`^${title}$`) });
		const around = heading.locator("xpath=ancestor::details");
		for (let level = 0; level < (await around.count()); level++) {
			const group = around.nth(level);
			if ((await group.getAttribute("open")) === null) await group.locator("> summary").click();
		}
	}

	/** Opens the disclosure of the panel that contains every group but the basics and the numbers. */
	openAdvanced(): Promise<void> {
		return this.openGroup("Advanced");
	}

	/** Runs an action and waits for the bunch that follows from it. */
	async regrown(action: () => Promise<unknown>): Promise<string> {
		const before = await this.fingerprint.innerText();
		await action();
		await expect(this.fingerprint).not.toHaveText(before);
		return this.fingerprint.innerText();
	}

	/** Opens the download sheet. */
	async openDownloads(): Promise<Locator> {
		await this.button("Download").click();
		const sheet = this.page.getByRole("dialog", { name: "Download", exact: true });
		await expect(sheet).toBeVisible();
		return sheet;
	}

	/** Opens the share sheet. */
	async openShare(): Promise<Locator> {
		await this.button("Share").click();
		const sheet = this.page.getByRole("dialog", { name: "Share this plant" });
		await expect(sheet).toBeVisible();
		return sheet;
	}

	/** Chooses a format of the download sheet by its key. */
	async chooseFormat(format: string): Promise<void> {
		await (await this.openDownloads()).locator(`[data-format=${format}]`).click();
	}

	/** Downloads a file by the key of its format. */
	download(format: string): Promise<{ name: string; bytes: Buffer }> {
		return this.downloaded(() => this.chooseFormat(format));
	}

	/** Runs an action and reads the file that it downloads. */
	async downloaded(action: () => Promise<void>): Promise<{ name: string; bytes: Buffer }> {
		const downloading = this.page.waitForEvent("download");
		await action();
		const download = await downloading;
		const chunks: Buffer[] = [];
		for await (const chunk of await download.createReadStream()) chunks.push(chunk as Buffer);
		return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
	}

	/** Drops a file on the page as a person would from a folder. */
	async drop(name: string, bytes: Buffer): Promise<void> {
		await this.page.evaluate(
			([fileName, base64]) => {
				const data = new DataTransfer();
				data.items.add(new File([Uint8Array.from(atob(base64), (char) => char.charCodeAt(0))], fileName));
				for (const type of ["dragenter", "dragover", "drop"]) {
					document.body.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
				}
			},
			[name, bytes.toString("base64")],
		);
	}

	/** The share of the view's pixels that are dark: berries and stems on the light paper. */
	inkOnCanvas(): Promise<number> {
		return this.inkOn(this.canvas);
	}

	async inkOn(view: Locator): Promise<number> {
		const { data } = await this.pixels(view);
		let dark = 0;
		for (let at = 0; at < data.length; at += 4) if (data[at] + data[at + 1] + data[at + 2] < 360) dark++;
		return dark / (data.length / 4);
	}

	/** Where on the page the lowest handle of the octahedron is: the lowest patch of the accent's colour. */
	async lowestHandle(): Promise<{ x: number; y: number } | undefined> {
		const { data, width } = await this.pixels();
		const near = (at: number) =>
			Math.abs(data[at] - 123) + Math.abs(data[at + 1] - 30) + Math.abs(data[at + 2] - 59) < 24;
		let last = data.length - 4;
		while (last >= 0 && !near(last)) last -= 4;
		if (last < 0) return undefined;
		const box = await this.canvas.boundingBox();
		const pixel = last / 4;
		return { x: (box?.x ?? 0) + (pixel % width), y: (box?.y ?? 0) + Math.floor(pixel / width) - 2 };
	}

	/** The pixels of a view, read from a screenshot: a WebGL canvas does not preserve them. Transitions are shown at their end. */
	async pixels(view = this.canvas): Promise<{ width: number; data: Uint8Array }> {
		const picture = await view.screenshot({ animations: "disabled" });
		const { width, base64 } = await this.page.evaluate(async (png) => {
			const bytes = Uint8Array.from(atob(png), (char) => char.charCodeAt(0));
			const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
			const context = new OffscreenCanvas(image.width, image.height).getContext(
				"2d",
			) as OffscreenCanvasRenderingContext2D;
			context.drawImage(image, 0, 0);
			const { data } = context.getImageData(0, 0, image.width, image.height);
			let text = "";
			for (let at = 0; at < data.length; at += 8192) text += String.fromCharCode(...data.subarray(at, at + 8192));
			return { width: image.width, base64: btoa(text) };
		}, picture.toString("base64"));
		return { width, data: Buffer.from(base64, "base64") };
	}

	/** Pixels by which the page is wider or higher than its window. */
	overflow(): Promise<number> {
		return this.page.evaluate(() => {
			const { scrollWidth, scrollHeight } = document.documentElement;
			return Math.max(scrollWidth - window.innerWidth, scrollHeight - window.innerHeight);
		});
	}
}

/** Drags a finger across the page, in pixels. */
export async function touchDrag(page: Page, from: { x: number; y: number }, dx: number, dy: number): Promise<void> {
	const session = await page.context().newCDPSession(page);
	const touch = (type: "touchStart" | "touchMove" | "touchEnd", points: { x: number; y: number }[]) =>
		session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
	await touch("touchStart", [from]);
	for (let step = 1; step <= 5; step++) {
		await touch("touchMove", [{ x: from.x + (dx * step) / 5, y: from.y + (dy * step) / 5 }]);
	}
	await touch("touchEnd", []);
}
