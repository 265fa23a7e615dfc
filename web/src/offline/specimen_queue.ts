/** Grows specimens one after the other in a worker, which is ended when a growth takes too long. */
import { MOST_WAITING, refusal, type SpecimenAnswer, type SpecimenRequest, TOO_MANY } from "./messages";

/** Milliseconds after which a growth is ended. */
const LONGEST_GROWTH = 30_000;
/**
 * Milliseconds without requests after which the worker ends: a core never gives back the memory of its largest plant.
 */
const REST = 10_000;

export interface SpecimenQueueOptions {
	/** Starts a worker of a classic script (specimens.ts). */
	start?(script: string): Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onerror">;
}

interface Job {
	readonly request: SpecimenRequest;
	readonly resolve: (answer: SpecimenAnswer) => void;
}

type Thread = ReturnType<NonNullable<SpecimenQueueOptions["start"]>>;

export class SpecimenQueue {
	readonly #start: (script: string) => Thread;
	readonly #waiting: Job[] = [];
	#running: Job | undefined;
	/** The worker with the script that it runs: pages may outlive a version of the app. */
	#thread: { readonly script: string; readonly worker: Thread } | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;

	constructor({ start = (script) => new Worker(script) }: SpecimenQueueOptions = {}) {
		this.#start = start;
	}

	/** Never rejects: where too many requests wait, or a growth takes too long, the answer is 503 with the reason. */
	request(request: SpecimenRequest): Promise<SpecimenAnswer> {
		return new Promise((resolve) => {
			if (this.#waiting.length >= MOST_WAITING) {
				resolve(refusal(TOO_MANY));
				return;
			}
			this.#waiting.push({ request, resolve });
			this.#next();
		});
	}

	#next(): void {
		if (this.#running) return;
		clearTimeout(this.#timer);
		const job = this.#waiting.shift();
		if (!job) {
			this.#timer = setTimeout(() => this.#end(), REST);
			return;
		}
		this.#running = job;
		const late = `it took more than ${LONGEST_GROWTH / 1000} s; request a smaller plant or a smaller file`;
		this.#timer = setTimeout(() => this.#break(refusal(late)), LONGEST_GROWTH);
		try {
			this.#workerFor(job.request.script).postMessage(job.request);
		} catch {
			this.#break({ type: "unable" });
		}
	}

	#workerFor(script: string): Thread {
		if (this.#thread?.script === script) return this.#thread.worker;
		this.#end();
		const worker = this.#start(script);
		// A worker that has ended may still have events in the queue.
		const isCurrent = () => this.#thread?.worker === worker;
		worker.onmessage = ({ data }: MessageEvent<SpecimenAnswer>) => {
			if (isCurrent()) this.#answer(data);
		};
		worker.onerror = (event) => {
			event.preventDefault(); // The service worker grows the specimen itself.
			if (isCurrent()) this.#break({ type: "unable" });
		};
		this.#thread = { script, worker };
		return worker;
	}

	/** Ends the running growth with its worker. */
	#break(answer: SpecimenAnswer): void {
		this.#end();
		this.#answer(answer);
	}

	#answer(answer: SpecimenAnswer): void {
		const job = this.#running;
		this.#running = undefined;
		job?.resolve(answer);
		this.#next();
	}

	#end(): void {
		this.#thread?.worker.terminate();
		this.#thread = undefined;
	}
}
