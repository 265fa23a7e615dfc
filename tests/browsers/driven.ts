/** A browser that is driven: what the two protocols have in common, and what both do alike. */
import { mkdirSync, mkdtempSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** One device's part of what hands do: the W3C's “actions”, which both protocols take as they are. */
export interface Device {
	readonly type: "key" | "pointer";
	readonly id: string;
	readonly actions: readonly Readonly<Record<string, string | number>>[];
}

/** A window of a browser. */
export interface Driven {
	readonly version: string;
	/** Goes to an address and waits until its page is loaded. */
	open(address: string): Promise<void>;
	/** Runs a script's expression in the page; a promise is waited for. What it gives has to be JSON. */
	evaluate(expression: string): Promise<unknown>;
	/** Moves pointers and presses keys. */
	act(devices: readonly Device[]): Promise<void>;
	/** What the window shows, as PNG. */
	picture(): Promise<Buffer>;
	/** What the browser's own console complained of since it was last asked. */
	complaints(): string[];
	close(): Promise<void>;
}

/** How large the page's window is; pixels. The flat views are higher than wide in it. */
export const WINDOW = { width: 1000, height: 760 };

const folder = fileURLToPath(new URL("../../build/browsers/", import.meta.url));

/** An empty folder for a browser: its profile, and what it downloads. It is in the repository, where packaged browsers may read too. */
export function home(): string {
	mkdirSync(folder, { recursive: true });
	return mkdtempSync(join(folder, "home-"));
}

/** Lets WebGL 2 be drawn by software where there is no graphics card, and shows it on that screen. */
export const onScreen = (display: string): NodeJS.ProcessEnv => ({
	...process.env,
	DISPLAY: display,
	GDK_BACKEND: "x11",
	MOZ_X11_EGL: "1",
	LIBGL_ALWAYS_SOFTWARE: "1",
});
