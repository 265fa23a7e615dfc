/** WebKitGTK's own small browser, over WebDriver by HTTP, which is all that its driver speaks. */
import { rmSync } from "node:fs";
import { freePort } from "../free_port.mjs";
import { type Driven, home, onScreen, WINDOW } from "./driven";
import { start } from "./processes";

/** Interval in milliseconds and number of attempts to reach a driver that has just started. */
const ATTEMPTS = { every: 50, times: 400 };

/** Timeout of scripts in the page, milliseconds. */
const PATIENCE = 120_000;

/** Opens a window of WebKit that saves to `downloads`. */
export async function openWebKit(program: string, display: string, downloads: string): Promise<Driven> {
	// Where no folder for downloads is known, that of the person is it.
	const own = home();
	const env = { ...onScreen(display), HOME: downloads, XDG_CONFIG_HOME: own, XDG_CACHE_HOME: own, XDG_DATA_HOME: own };
	const port = await freePort();
	const driver = await start(program, [`--port=${port}`], undefined, env);
	const close = async () => {
		await driver.end();
		rmSync(own, { recursive: true, force: true, maxRetries: 5 });
	};
	try {
		return await windowOf(`http://127.0.0.1:${port}/session`, close);
	} catch (error) {
		await close();
		throw error;
	}
}

async function windowOf(sessions: string, close: () => Promise<void>): Promise<Driven> {
	const { sessionId, capabilities } = (await listening(() =>
		call(sessions, { capabilities: { alwaysMatch: { timeouts: { script: PATIENCE } } } }),
	)) as { sessionId: string; capabilities: { browserVersion: string } };
	const address = `${sessions}/${sessionId}`;
	const evaluate = (expression: string) =>
		call(`${address}/execute/sync`, { script: `return (async () => (await (${expression})) ?? null)()`, args: [] });
	await suit(address, evaluate);
	return {
		version: `WebKitGTK ${capabilities.browserVersion}`,
		async open(url) {
			await call(`${address}/url`, { url });
		},
		evaluate,
		async act(devices) {
			await call(`${address}/actions`, { actions: devices });
		},
		async picture() {
			return Buffer.from((await call(`${address}/screenshot`)) as string, "base64");
		},
		// The driver does not report console messages; the page's own listener (complaints.js) does.
		complaints: () => [],
		close,
	};
}

/** Makes the window so large that the page within has its size. */
async function suit(address: string, evaluate: (expression: string) => Promise<unknown>): Promise<void> {
	const resize = (width: number, height: number) => call(`${address}/window/rect`, { x: 0, y: 0, width, height });
	await resize(WINDOW.width, WINDOW.height);
	const [width, height] = (await evaluate("[innerWidth, innerHeight]")) as [number, number];
	await resize(2 * WINDOW.width - width, 2 * WINDOW.height - height);
}

/** Repeats a request until the driver listens. */
async function listening<Result>(request: () => Promise<Result>): Promise<Result> {
	for (let times = 1; ; times++) {
		try {
			return await request();
		} catch (error) {
			if (!(error instanceof TypeError) || times === ATTEMPTS.times) throw error;
			await new Promise((resolve) => setTimeout(resolve, ATTEMPTS.every));
		}
	}
}

/** @throws TypeError when the driver does not listen; Error with the driver's message */
async function call(address: string, body?: object): Promise<unknown> {
	const response = await fetch(address, body ? { method: "POST", body: JSON.stringify(body) } : {});
	const { value } = (await response.json()) as { value: unknown };
	if (!response.ok) throw new Error(`${address}: ${(value as { message: string }).message}`);
	return value;
}
