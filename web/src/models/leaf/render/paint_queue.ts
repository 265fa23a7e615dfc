/** Paints leaves in a worker, so that the page does not wait. */
import { startWorker } from "../../../core/spawn";
import type { FlatLeaf } from "../parts/face_pictures";
import { type BladeTextures, type PaintedLeaf, Painter, type PaintOrder } from "./paint";
import address from "./paint_worker.ts?worker&url";

/** The part of a worker that the queue uses. */
export type PaintWorker = Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onerror">;

/** A queue with one order in progress and at most one waiting: a new order replaces the waiting one. */
export class PaintQueue {
	readonly #deliver: (faces: BladeTextures, preview: boolean) => void;
	readonly #start: () => PaintWorker;
	#worker: PaintWorker | undefined;
	/** Paints on this thread after the worker has failed. */
	#localPainter: Painter | undefined;
	/** The leaf that the worker, or the local painter, has received last. */
	#lastLeaf: FlatLeaf | undefined;
	#inProgress: { order: PaintOrder; leaf: FlatLeaf } | undefined;
	#next: { leaf: FlatLeaf; specimen: PaintOrder["specimen"]; preview: boolean } | undefined;
	/** Id of the newest order; ids count from 1. */
	#newestId = 0;
	/** Id of the order whose textures are still to be delivered; 0 for none. */
	#wantedId = 0;
	/** Resolve the promises of `whenDone`. */
	readonly #waiting: (() => void)[] = [];

	/** @param deliver receives textures that are still wanted, and whether they are of a preview */
	constructor(deliver: (faces: BladeTextures, preview: boolean) => void, start: () => PaintWorker = startPainter) {
		this.#deliver = deliver;
		this.#start = start;
	}

	/** Replaces the waiting order. During previews the order in progress stays wanted. */
	order(leaf: FlatLeaf, { look, parameters, seed }: PaintOrder["specimen"], preview = false): void {
		this.#wantedId = ++this.#newestId;
		this.#next = { leaf, specimen: { look, parameters, seed }, preview };
		if (!this.#inProgress) this.#begin();
	}

	/** Resolves when no order is wanted any more. */
	whenDone(): Promise<void> {
		if (this.#wantedId === 0) return Promise.resolve();
		return new Promise((resolve) => this.#waiting.push(resolve));
	}

	/** Drops all orders and ends the worker. */
	dispose(): void {
		this.#wantedId = 0;
		this.#next = undefined;
		this.#resolveWaiting();
		this.#worker?.terminate();
	}

	/**
	 * Starts the waiting order, if there is one. The leaf is only sent if the worker does not have it from the order
	 * before, and without its other fields, which painting does not use and cloning for the worker would copy.
	 */
	#begin(): void {
		if (!this.#next) return;
		const { leaf, specimen, preview } = this.#next;
		this.#next = undefined;
		const { chart, margin, square, energy, segments } = leaf;
		const flat = { chart, margin, square, energy, segments: { count: segments.count, radii: segments.radii } };
		const order = { id: this.#newestId, specimen, preview, ...(leaf === this.#lastLeaf ? {} : { leaf: flat }) };
		this.#inProgress = { order, leaf };
		this.#lastLeaf = leaf;
		if (this.#localPainter) this.#paint(this.#localPainter);
		else this.#send(order);
	}

	/** Sends an order to the worker; paints here an order that cannot be cloned. */
	#send(order: PaintOrder): void {
		try {
			this.#startedWorker().postMessage(order);
		} catch {
			this.#paintAlone();
		}
	}

	/** Returns the worker, started for the first order; if it fails, this thread paints. */
	#startedWorker(): PaintWorker {
		if (this.#worker) return this.#worker;
		const worker = this.#start();
		worker.onmessage = ({ data }: MessageEvent<PaintedLeaf>) => this.#take(data);
		worker.onerror = (event) => {
			event.preventDefault(); // Handled here: keeps the error out of the console.
			this.#paintAlone();
		};
		this.#worker = worker;
		return worker;
	}

	/** Paints without a worker from now on. */
	#paintAlone(): void {
		this.#worker?.terminate();
		this.#localPainter = new Painter();
		this.#paint(this.#localPainter);
	}

	/** Paints the order in progress on this thread. */
	#paint(painter: Painter): void {
		if (!this.#inProgress) return;
		const { order, leaf } = this.#inProgress;
		this.#take({ ...painter.paint({ ...order, leaf }), id: order.id });
	}

	/**
	 * Delivers painted textures if they are still wanted; during a drag also those of an older preview, because in a fast
	 * drag the newest one would rarely be ready in time.
	 */
	#take({ id, ...faces }: PaintedLeaf): void {
		const preview = this.#inProgress?.order.preview ?? false;
		this.#inProgress = undefined;
		if (id === this.#wantedId) {
			this.#wantedId = 0;
			this.#deliver(faces, preview);
			this.#resolveWaiting();
		} else if (preview && this.#next?.preview) this.#deliver(faces, preview);
		this.#begin();
	}

	/** Resolves the promises of `whenDone`. */
	#resolveWaiting(): void {
		for (const resolve of this.#waiting.splice(0)) resolve();
	}
}

/** Starts the worker that paints leaves. */
function startPainter(): PaintWorker {
	return startWorker(new URL(address, import.meta.url));
}
