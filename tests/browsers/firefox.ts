/** Firefox, over WebDriver BiDi, which it speaks by itself. */
import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { type Device, type Driven, home, onScreen, WINDOW } from "./driven";
import { start } from "./processes";

/** Preferences: no background requests, and downloads without a question. */
const preferences = (downloads: string) => ({
	"webgl.force-enabled": true,
	"browser.download.folderList": 2,
	"browser.download.dir": downloads,
	"browser.download.alwaysOpenPanel": false,
	"browser.shell.checkDefaultBrowser": false,
	"browser.startup.homepage_override.mstone": "ignore",
	"datareporting.policy.dataSubmissionEnabled": false,
	"app.normandy.enabled": false,
	// After navigation Firefox logs errors of pending service worker requests; offline.spec.ts tests them.
	"dom.serviceWorkers.enabled": false,
	"app.update.enabled": false,
	"network.captive-portal-service.enabled": false,
	"network.connectivity-service.enabled": false,
	"services.settings.server": "data:,",
	"toolkit.telemetry.server": "data:,",
});

interface Evaluated {
	readonly type: "success" | "exception";
	readonly result: { readonly value?: string };
	readonly exceptionDetails?: { readonly text: string };
}

/** Opens a window of Firefox that saves to `downloads`. */
export async function openFirefox(program: string, display: string, downloads: string): Promise<Driven> {
	const profile = home();
	const lines = Object.entries(preferences(downloads)).map(
		([key, value]) => `user_pref(${JSON.stringify(key)}, ${JSON.stringify(value)});\n`,
	);
	writeFileSync(join(profile, "user.js"), lines.join(""));
	const args = ["--remote-debugging-port=0", "--profile", profile, "--no-remote", "about:blank"];
	const process = await start(program, args, /WebDriver BiDi listening on (ws:\S+)/, onScreen(display));
	const close = async () => {
		await process.end();
		rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
	};
	try {
		const session = await Session.connect(`${process.output}/session`);
		return await windowOf(session, close);
	} catch (error) {
		await close();
		throw error;
	}
}

async function windowOf(session: Session, close: () => Promise<void>): Promise<Driven> {
	const { capabilities } = await session.call<{ capabilities: { browserVersion: string } }>("session.new", {
		capabilities: {},
	});
	await session.call("session.subscribe", { events: ["log.entryAdded"] });
	const { contexts } = await session.call<{ contexts: { context: string }[] }>("browsingContext.getTree", {});
	const { context } = contexts[0];
	await session.call("browsingContext.setViewport", { context, viewport: WINDOW });
	return {
		version: `Firefox ${capabilities.browserVersion}`,
		async open(url) {
			await session.call("browsingContext.navigate", { context, url, wait: "complete" });
		},
		async evaluate(expression) {
			const { result, exceptionDetails } = await session.call<Evaluated>("script.evaluate", {
				expression: `(async () => JSON.stringify((await (${expression})) ?? null))()`,
				target: { context },
				awaitPromise: true,
			});
			if (exceptionDetails) throw new Error(exceptionDetails.text);
			return JSON.parse(result.value ?? "null");
		},
		async act(devices: readonly Device[]) {
			await session.call("input.performActions", { context, actions: devices });
		},
		async picture() {
			const { data } = await session.call<{ data: string }>("browsingContext.captureScreenshot", { context });
			return Buffer.from(data, "base64");
		},
		complaints: () => session.complaints.splice(0),
		async close() {
			session.end();
			await close();
		},
	};
}

interface Message {
	readonly type: "success" | "error" | "event";
	readonly id?: number;
	readonly result?: unknown;
	readonly message?: string;
	readonly params?: { readonly level?: string; readonly text?: string };
}

/** A WebDriver BiDi session: commands and responses have numbers, messages without a number are console entries. */
class Session {
	readonly complaints: string[] = [];
	readonly #socket: WebSocket;
	readonly #waiting = new Map<number, (message: Message) => void>();
	#last = 0;

	private constructor(socket: WebSocket) {
		this.#socket = socket;
		socket.onmessage = ({ data }) => this.#hear(JSON.parse(data));
		socket.onclose = () => {
			for (const answer of this.#waiting.values()) answer({ type: "error", message: "Firefox has gone" });
		};
	}

	static connect(address: string): Promise<Session> {
		const socket = new WebSocket(address);
		return new Promise((resolve, reject) => {
			socket.onopen = () => resolve(new Session(socket));
			socket.onerror = () => reject(new Error(`No answer at ${address}`));
		});
	}

	call<Result>(method: string, params: object): Promise<Result> {
		const id = ++this.#last;
		return new Promise((resolve, reject) => {
			this.#waiting.set(id, ({ type, result, message }) => {
				if (type === "error") reject(new Error(`${method}: ${message}`));
				else resolve(result as Result);
			});
			this.#socket.send(JSON.stringify({ id, method, params }));
		});
	}

	#hear(message: Message): void {
		if (message.type === "event") {
			const { level, text } = message.params ?? {};
			if (level === "error") this.complaints.push(`console: ${text}`);
			return;
		}
		const id = message.id ?? 0;
		this.#waiting.get(id)?.(message);
		this.#waiting.delete(id);
	}

	end(): void {
		this.#socket.close();
	}
}
