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
	/** Paints on this thread where no worker is available. */
	#alone: Painter | undefined;
	/** The leaf that the worker has received. */
	#given: FlatLeaf | undefined;
	#underWay: { order: PaintOrder; leaf: FlatLeaf } | undefined;
	#next: { leaf: FlatLeaf; specimen: PaintOrder["specimen"]; preview: boolean } | undefined;
	#orders = 0;
	#wanted = 0;
	readonly #waiting: (() => void)[] = [];

	/** @param deliver receives textures that are still wanted, and whether they are of a preview */
	constructor(deliver: (faces: BladeTextures, preview: boolean) => void, start: () => PaintWorker = startPainter) {
		this.#deliver = deliver;
		this.#start = start;
	}

	/** Replaces the waiting order. During previews the order in progress stays wanted. */
	order(leaf: FlatLeaf, { look, parameters, seed }: PaintOrder["specimen"], preview = false): void {
		this.#wanted = ++this.#orders;
		this.#next = { leaf, specimen: { look, parameters, seed }, preview };
		if (!this.#underWay) this.#begin();
	}

	/** Resolves when no order is wanted any more. */
	whenDone(): Promise<void> {
		if (this.#wanted === 0) return Promise.resolve();
		return new Promise((resolve) => this.#waiting.push(resolve));
	}

	dispose(): void {
		this.#wanted = 0;
		this.#next = undefined;
		this.#wake();
		this.#worker?.terminate();
	}

	#begin(): void {
		if (!this.#next) return;
		const { leaf, specimen, preview } = this.#next;
		this.#next = undefined;
		const { chart, margin, square, energy, segments } = leaf;
		const flat = { chart, margin, square, energy, segments: { count: segments.count, radii: segments.radii } };
		const order = { id: this.#orders, specimen, preview, ...(leaf === this.#given ? {} : { leaf: flat }) };
		this.#underWay = { order, leaf };
		this.#given = leaf;
		if (this.#alone) this.#paint(this.#alone);
		else this.#send(order);
	}

	/** Sends an order to the worker; paints here an order that cannot be cloned. */
	#send(order: PaintOrder): void {
		try {
			this.#employ().postMessage(order);
		} catch {
			this.#paintAlone();
		}
	}

	#employ(): PaintWorker {
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
		this.#alone = new Painter();
		this.#paint(this.#alone);
	}

	/** Paints the order in progress on this thread. */
	#paint(painter: Painter): void {
		if (!this.#underWay) return;
		const { order, leaf } = this.#underWay;
		this.#take({ ...painter.paint({ ...order, leaf }), id: order.id });
	}

	#take({ id, ...faces }: PaintedLeaf): void {
		const preview = this.#underWay?.order.preview ?? false;
		this.#underWay = undefined;
		if (id === this.#wanted) {
			this.#wanted = 0;
			this.#deliver(faces, preview);
			this.#wake();
		} else if (preview && this.#next?.preview) this.#deliver(faces, preview);
		this.#begin();
	}

	#wake(): void {
		for (const resolve of this.#waiting.splice(0)) resolve();
	}
}

function startPainter(): PaintWorker {
	return startWorker(new URL(address, import.meta.url));
}
