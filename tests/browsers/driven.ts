/** A browser under remote control: the common interface of the two protocols. */
import { mkdirSync, mkdtempSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The actions of one input device: W3C “actions”, which both protocols accept. */
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
	/** Evaluates a script's expression in the page and awaits promises. The result must be JSON. */
	evaluate(expression: string): Promise<unknown>;
	/** Moves pointers and presses keys. */
	act(devices: readonly Device[]): Promise<void>;
	/** A screenshot of the window as PNG. */
	picture(): Promise<Buffer>;
	/** Errors in the browser's console since the last call. */
	complaints(): string[];
	close(): Promise<void>;
}

/** How large the page's window is; pixels. The flat views are higher than wide in it. */
export const WINDOW = { width: 1000, height: 760 };

const folder = fileURLToPath(new URL("../../build/browsers/", import.meta.url));

/**
 * An empty folder for a browser's profile and downloads, in the repository, because packaged browsers can read there.
 */
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
