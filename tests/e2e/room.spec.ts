import type { Page } from "@playwright/test";
import { compressText } from "../../web/src/specimen/compressed_text";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** Makes a page believe that it can open Quick Look, and keeps the files of its addresses. */
const withQuickLook = (page: Page) =>
	page.addInitScript(() => {
		DOMTokenList.prototype.supports = (token) => token === "ar";
		const files = new Map<string, Blob>();
		Object.assign(window, { files });
		const create = URL.createObjectURL;
		URL.createObjectURL = (file: Blob) => {
			const address = create.call(URL, file);
			files.set(address, file);
			return address;
		};
	});

/** Reports and commands of a simulated device; lengths in metres. */
interface Device {
	/** The point of the floor in front of the device, if it finds one. */
	floor?: [number, number, number];
	/** Origin of the space in which the page read the position of the device last. */
	origin: [number, number, number];
	/** Number of pixels drawn over the camera's picture in the last frame. */
	drawn: number;
	tap(): void;
	/** Ends the session, as the device's back gesture does. */
	leave(): void;
}

/**
 * Simulates a device for augmented reality that is held upright at the origin of the room.
 * @param refuses whether the user refuses the session
 */
const withDevice = (page: Page, refuses = false) =>
	page.addInitScript((isRefused) => {
		type Point = [number, number, number];
		const [width, height] = [320, 480];
		class Transform {
			readonly position: { x: number; y: number; z: number };
			readonly matrix: Float32Array;
			constructor({ x = 0, y = 0, z = 0 }: { x?: number; y?: number; z?: number } = {}) {
				this.position = { x, y, z };
				this.matrix = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]);
			}
		}
		class Space {
			constructor(readonly origin: Point = [0, 0, 0]) {}
			getOffsetReferenceSpace({ position: { x, y, z } }: Transform) {
				return new Space([this.origin[0] + x, this.origin[1] + y, this.origin[2] + z]);
			}
			of([x, y, z]: Point) {
				return new Transform({ x: x - this.origin[0], y: y - this.origin[1], z: z - this.origin[2] });
			}
		}
		class Session extends EventTarget {
			environmentBlendMode = "alpha-blend";
			inputSources = [];
			enabledFeatures = ["hit-test"];
			updateRenderState() {}
			async requestReferenceSpace() {
				return new Space();
			}
			async requestHitTestSource() {
				return {};
			}
			requestAnimationFrame(draw: (now: number, frame: unknown) => void) {
				return setTimeout(() => {
					draw(performance.now(), frame);
					device.drawn = drawnPixels();
				}, 50);
			}
			cancelAnimationFrame(id: number) {
				clearTimeout(id);
			}
			async end() {
				this.dispatchEvent(new Event("end"));
			}
		}
		const session = new Session();
		const device: Device = {
			origin: [0, 0, 0],
			drawn: 0,
			tap: () => session.dispatchEvent(new Event("select")),
			leave: () => session.dispatchEvent(new Event("end")),
		};
		// An angle of view of 90° upwards.
		const projection = [height / width, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.001, -1, 0, 0, -0.02, 0];
		const frame = {
			getViewerPose: (space: Space) => {
				device.origin = space.origin;
				const transform = space.of([0, 0, 0]);
				return { transform, views: [{ eye: "none", transform, projectionMatrix: new Float32Array(projection) }] };
			},
			getHitTestResults: () => {
				const { floor } = device;
				return floor ? [{ getPose: (space: Space) => ({ transform: space.of(floor) }) }] : [];
			},
		};
		let screen: { gl: WebGL2RenderingContext; buffer: WebGLFramebuffer } | undefined;
		const drawnPixels = () => {
			const bytes = new Uint8Array(4 * width * height);
			if (!screen) return 0;
			const { gl, buffer } = screen;
			gl.bindFramebuffer(gl.READ_FRAMEBUFFER, buffer);
			gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
			gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
			let count = 0;
			for (let at = 0; at < bytes.length; at += 4) if (bytes[at + 3] > 0) count++;
			return count;
		};
		/** Creates the framebuffer of the device's screen. */
		const framebufferOf = (gl: WebGL2RenderingContext) => {
			const buffer = gl.createFramebuffer();
			gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
			for (const [format, use] of [
				[gl.RGBA8, gl.COLOR_ATTACHMENT0],
				[gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
			]) {
				const store = gl.createRenderbuffer();
				gl.bindRenderbuffer(gl.RENDERBUFFER, store);
				gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
				gl.framebufferRenderbuffer(gl.FRAMEBUFFER, use, gl.RENDERBUFFER, store);
			}
			gl.bindFramebuffer(gl.FRAMEBUFFER, null);
			screen = { gl, buffer };
			return buffer;
		};
		class Layer {
			framebuffer: WebGLFramebuffer;
			framebufferWidth = width;
			framebufferHeight = height;
			constructor(_session: Session, gl: WebGL2RenderingContext) {
				this.framebuffer = framebufferOf(gl);
			}
			getViewport = () => ({ x: 0, y: 0, width, height });
		}
		Object.assign(window, { device, XRRigidTransform: Transform, XRWebGLLayer: Layer });
		WebGL2RenderingContext.prototype.makeXRCompatible = async () => {};
		const xr = {
			isSessionSupported: async (mode: string) => mode === "immersive-ar",
			requestSession: async (_mode: string, { requiredFeatures }: { requiredFeatures: string[] }) => {
				if (isRefused) throw new DOMException("refused", "NotAllowedError");
				if (!requiredFeatures.includes("hit-test")) throw new Error("no surfaces");
				return session;
			},
		};
		Object.defineProperty(navigator, "xr", { value: xr });
	}, refuses);

/** A value of the simulated device. */
const reported = <Key extends keyof Device>(page: Page, key: Key) =>
	page.evaluate((name) => (window as unknown as { device: Device }).device[name], key) as Promise<Device[Key]>;

/** Does something with the simulated device. */
const withSimulated = (page: Page, use: "tap" | "leave" | [number, number, number]) =>
	page.evaluate((how) => {
		const { device } = window as unknown as { device: Device };
		if (typeof how === "string") device[how]();
		else device.floor = how;
	}, use);

/** The file of an address in the page. */
async function fileAt(page: Page, address: string): Promise<{ type: string; bytes: Buffer }> {
	const { type, base64 } = await page.evaluate(async (at) => {
		const file = (window as unknown as { files: Map<string, Blob> }).files.get(at) as Blob;
		let text = "";
		for (const byte of new Uint8Array(await file.arrayBuffer())) text += String.fromCharCode(byte);
		return { type: file.type, base64: btoa(text) };
	}, address);
	return { type, bytes: Buffer.from(base64, "base64") };
}

/** Reads the entries of a ZIP file by its local headers. */
function entriesOf(bytes: Buffer): { name: string; method: number; start: number; data: Buffer }[] {
	const entries = [];
	for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50; ) {
		const start = at + 30 + bytes.readUInt16LE(at + 26) + bytes.readUInt16LE(at + 28);
		const end = start + bytes.readUInt32LE(at + 18);
		const name = bytes.toString("utf8", at + 30, at + 30 + bytes.readUInt16LE(at + 26));
		entries.push({ name, method: bytes.readUInt16LE(at + 8), start, data: bytes.subarray(start, end) });
		at = end;
	}
	return entries;
}

test("where Quick Look exists, the plant can be viewed in the room, in its real size", async ({ page }) => {
	await withQuickLook(page);
	const text = await compressText("axiom: F(100)\n");
	const studio = await new StudioPage(page).open(`?v=2&model=grammar&unit=5&thickness=2#g=${text}`);
	await studio.stands();
	await studio.button("View in your room").click();
	const link = page
		.getByRole("dialog", { name: "Download", exact: true })
		.getByRole("link", { name: "View in your room" });
	await expect(link).toBeFocused({ timeout: 60_000 });
	await expect(link).toHaveAttribute("rel", "ar");
	// Quick Look opens a link only if a picture is its single element.
	expect(await link.evaluate(({ children }) => [...children].map(({ tagName }) => tagName))).toEqual(["IMG"]);
	const { type, bytes } = await fileAt(page, (await link.getAttribute("href")) as string);
	expect(type).toBe("model/vnd.usdz+zip");
	const entries = entriesOf(bytes);
	expect(entries[0].name).toMatch(/\.usda$/);
	for (const { method, start } of entries) expect([method, start % 64]).toEqual([0, 0]);
	const layer = entries[0].data.toString();
	expect(layer).toMatch(/^#usda 1\.0\n/);
	expect(layer).toContain("metersPerUnit = 1\n");
	const boxes = [...layer.matchAll(/extent = \[\(([^)]+)\), \(([^)]+)\)\]/g)];
	const heights = boxes.map(([, low, high]) => [Number(low.split(",")[1]), Number(high.split(",")[1])]);
	const height = Math.max(...heights.map(([, high]) => high)) - Math.min(...heights.map(([low]) => low));
	expect(Math.abs(height / 0.5 - 1)).toBeLessThan(0.02);
});

/** Opens a shoot 0.5 m high. */
async function openShoot(page: Page): Promise<StudioPage> {
	const text = await compressText("axiom: F(100)\n");
	const studio = await new StudioPage(page).open(`?v=2&model=grammar&unit=5&thickness=20#g=${text}`);
	await studio.stands();
	return studio;
}

test.describe("a session", () => {
	test.use({ drawn: true });

	test("with WebXR, taps place the plant on the floor, and leaving restores the view", async ({ page }) => {
		await withDevice(page);
		const studio = await openShoot(page);
		const canvas = page.locator(".stage-surface");
		const size = () => canvas.evaluate(({ width, height }: HTMLCanvasElement) => [width, height]);
		const before = await size();
		const box = await canvas.boundingBox();
		if (!box) throw new Error("no view");
		// The plant alone, without the tools beside it.
		const clip = { x: box.x + 0.3 * box.width, y: box.y, width: 0.3 * box.width, height: 0.8 * box.height };
		let picture = await page.screenshot({ clip });
		await expect
			.poll(async () => {
				const last = picture;
				picture = await page.screenshot({ clip });
				return picture.equals(last);
			})
			.toBe(true);
		const room = studio.button("View in your room");
		await room.click();
		await expect(page.getByText("Point the phone at the floor, then tap to place the plant.")).toBeVisible();
		await withSimulated(page, "tap");
		expect(await reported(page, "drawn")).toBe(0);
		await withSimulated(page, [0, -0.6, -1]);
		await expect.poll(() => reported(page, "drawn")).toBeGreaterThan(20);
		const ring = await reported(page, "drawn");
		await withSimulated(page, "tap");
		await expect(page.getByText("Tap again to move the plant.")).toBeVisible();
		// The shoot is 0.5 m of the 2 m that 480 pixels show at this distance.
		await expect.poll(() => reported(page, "drawn")).toBeGreaterThan(ring + 120);
		const [x, y, z] = await reported(page, "origin");
		expect([x, z]).toEqual([0, -1]);
		expect(Math.abs(y + 0.6)).toBeLessThan(0.03);
		await withSimulated(page, [0, -0.6, -2]);
		await withSimulated(page, "leave");
		await expect(page.locator(".room-overlay")).toHaveCount(0);
		await expect(room).toBeFocused();
		await expect.poll(size).toEqual(before);
		await expect.poll(async () => (await page.screenshot({ clip })).equals(picture)).toBe(true);

		await room.click();
		await page.getByRole("button", { name: "Close", exact: true }).click();
		await expect(page.locator(".room-overlay")).toHaveCount(0);
		await expect.poll(size).toEqual(before);
	});
});

test("a refused session ends in a notice that says what to do", async ({ page }) => {
	await withDevice(page, true);
	const studio = await openShoot(page);
	await studio.button("View in your room").click();
	await expect(page.getByText("The browser did not allow the view of your room")).toBeVisible();
	await expect(page.getByText("Allow this page to use the camera and augmented reality")).toBeVisible();
	await expect(page.locator(".room-overlay")).toHaveCount(0);
});

test("elsewhere nothing offers a view in the room", async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await studio.stands();
	await expect(studio.button("Measure")).toBeVisible();
	await expect(studio.button("View in your room")).toHaveCount(0);
	const sheet = await studio.openDownloads();
	await expect(sheet.locator("[data-purpose=ar] .size")).not.toHaveText("…", { timeout: 60_000 });
	await expect(page.getByText("View in your room")).toHaveCount(0);
});
