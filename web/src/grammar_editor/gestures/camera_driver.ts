/**
 * Hand tracking by @mediapipe/hands. The library's files are next to the app, in `hands/`, and load when the camera is
 * chosen. The camera's picture never leaves the page.
 */

import { text } from "../messages.generated";
import type { Driver, DriverEvents } from "./driver";
import { HandReader, type Landmark } from "./hand";

/** Used part of the API of @mediapipe/hands, whose script is not a module. */
interface HandsFinder {
	setOptions(options: { maxNumHands: number; modelComplexity: 0 | 1; minDetectionConfidence: number }): void;
	onResults(listener: (results: { readonly multiHandLandmarks?: readonly (readonly Landmark[])[] }) => void): void;
	initialize(): Promise<void>;
	send(inputs: { image: HTMLVideoElement }): Promise<void>;
	close(): Promise<void>;
}
type HandsMaker = new (config: { locateFile(file: string): string }) => HandsFinder;

const FOLDER = "hands/";
/** Requested picture size: small pictures are faster to search, and are sufficient to find one hand. */
const SIZE = { width: { ideal: 320 }, height: { ideal: 240 } } as const;
/** Time after which a resting hand ends an undo step, seconds. */
const STILL = 0.8;
/** Largest tremor of a resting hand, as a share of the range. */
const TREMBLE = 0.01;

export class CameraDriver implements Driver {
	readonly #video: HTMLVideoElement;
	readonly #events: DriverEvents;
	readonly #reader = new HandReader();
	#stream: MediaStream | undefined;
	#finder: HandsFinder | undefined;
	#stopped = false;
	#seen: boolean | undefined;
	#rested: { x: number; y: number; since: number; reported: boolean } | undefined;

	/** @param video element that shows the camera's picture */
	constructor(video: HTMLVideoElement, events: DriverEvents) {
		this.#video = video;
		this.#events = events;
		void this.#start();
	}

	/** Ends hand tracking and releases the camera. */
	stop(): void {
		this.#stopped = true;
		for (const track of this.#stream?.getTracks() ?? []) track.stop();
		this.#stream = undefined;
		this.#video.srcObject = null;
		const finder = this.#finder;
		this.#finder = undefined;
		// A finder that has not started rejects here.
		void finder?.close().catch(() => {});
	}

	/** Opens the camera and follows hands in its picture; each step ends if the driver was stopped meanwhile. */
	async #start(): Promise<void> {
		this.#events.report(text("camera_asks"));
		try {
			const stream = await requestCamera();
			this.#stream = stream;
			if (this.#stopped) return this.stop();
			for (const track of stream.getTracks())
				track.addEventListener("ended", () => this.#fail(new DOMException("", "AbortError")));
			this.#video.srcObject = stream;
			await this.#video.play();
			if (this.#stopped) return;
			this.#events.report(text("hands_loading"));
			const finder = await findHands((landmarks) => this.#handleLandmarks(landmarks));
			this.#finder = finder;
			if (this.#stopped) return this.stop();
			await this.#look(finder);
		} catch (error) {
			this.#fail(error);
		}
	}

	/** Stops and reports the error, unless the driver was stopped already. */
	#fail(error: unknown): void {
		if (this.#stopped) return;
		this.stop();
		this.#events.fail(reasonOf(error));
	}

	/** Analyses pictures one after the other. */
	async #look(finder: HandsFinder): Promise<void> {
		while (!this.#stopped) {
			// While the page is hidden, no picture is analysed.
			if (!document.hidden && this.#video.readyState >= HTMLMediaElement.HAVE_CURRENT_DATA)
				await finder.send({ image: this.#video });
			await new Promise((resolve) => setTimeout(resolve, document.hidden ? 300 : 16));
		}
	}

	/** Reports that hands come, go, pinch and move; trembling at rest counts as no movement. */
	#handleLandmarks(landmarks: readonly Landmark[] | undefined): void {
		if (this.#stopped) return;
		const now = performance.now() / 1000;
		const hand = this.#reader.read(landmarks, now);
		if ((hand !== undefined) !== this.#seen) {
			this.#seen = hand !== undefined;
			this.#events.report(text(hand ? "hand_seen" : "hand_missing"));
			if (!hand) this.#events.rest();
		}
		if (!hand) return;
		if (hand.pinched) this.#events.next();
		const { x, y } = hand;
		const rested = this.#rested;
		if (rested && Math.hypot(x - rested.x, y - rested.y) < TREMBLE) {
			if (rested.reported || now - rested.since < STILL) return;
			rested.reported = true;
			this.#events.rest();
			return;
		}
		this.#rested = { x, y, since: now, reported: false };
		this.#events.move({ x, y });
	}
}

/**
 * Opens the user's camera.
 * @throws DOMException if there is none, or the user refuses
 */
async function requestCamera(): Promise<MediaStream> {
	// Pages without HTTPS have no `mediaDevices`.
	const { mediaDevices } = navigator as { readonly mediaDevices?: MediaDevices };
	if (!mediaDevices) throw new DOMException("no camera here", "NotFoundError");
	return mediaDevices.getUserMedia({ video: { facingMode: "user", ...SIZE }, audio: false });
}

/**
 * Loads the library and starts it.
 * @param found receives the landmarks of one hand in each picture, or undefined if there is none
 */
async function findHands(found: (landmarks: readonly Landmark[] | undefined) => void): Promise<HandsFinder> {
	const addressOf = (file: string) => new URL(FOLDER + file, document.baseURI).href;
	await loadScript(addressOf("hands.js"));
	const { Hands } = globalThis as unknown as { readonly Hands: HandsMaker };
	const finder = new Hands({ locateFile: addressOf });
	finder.setOptions({ maxNumHands: 1, modelComplexity: 0, minDetectionConfidence: 0.6 });
	finder.onResults(({ multiHandLandmarks }) => found(multiHandLandmarks?.[0]));
	await finder.initialize();
	return finder;
}

/**
 * Loads a classic script once; a script that failed is loaded again.
 * @throws Error if it cannot be fetched
 */
function loadScript(address: string): Promise<void> {
	const before = document.querySelector<HTMLScriptElement>(`script[src="${address}"]`);
	if (before?.dataset.loaded) return Promise.resolve();
	before?.remove();
	return new Promise((resolve, reject) => {
		const element = Object.assign(document.createElement("script"), { src: address });
		element.addEventListener("load", () => {
			element.dataset.loaded = "true";
			resolve();
		});
		element.addEventListener("error", () => reject(new Error("not fetched")));
		document.head.append(element);
	});
}

/** Returns the message on an error of the camera or of loading the library. */
function reasonOf(error: unknown): string {
	const { name } = error as Partial<DOMException>;
	if (name === "NotAllowedError") return text("camera_refused");
	if (name === "NotFoundError" || name === "OverconstrainedError") return text("camera_none");
	if (name === "AbortError") return text("camera_gone");
	if (name === "NotReadableError") return text("camera_busy");
	return text("hands_not_loaded");
}
