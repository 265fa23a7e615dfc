/** Grows specimens one after the other in a worker, which is ended when a growth takes too long. */
import { MAX_WAITING, refusal, type SpecimenAnswer, type SpecimenRequest } from "./messages";
import { text } from "./messages.generated";

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

	/**
	 * Grows a specimen in the worker, after those before it. Never rejects: where too many requests wait, or a growth
	 * takes too long, the answer is 503 with the reason.
	 * @param signal cancels: a running growth ends with its worker, and the answer is "unable"
	 */
	request(request: SpecimenRequest, signal?: AbortSignal): Promise<SpecimenAnswer> {
		return new Promise((resolve) => {
			if (signal?.aborted) {
				resolve({ type: "unable" });
				return;
			}
			if (this.#waiting.length >= MAX_WAITING) {
				resolve(refusal(text("too_many_requests")));
				return;
			}
			const job = { request, resolve };
			signal?.addEventListener("abort", () => this.#cancel(job), { once: true });
			this.#waiting.push(job);
			this.#next();
		});
	}

	/** Ends a job that runs or waits. */
	#cancel(job: Job): void {
		const at = this.#waiting.indexOf(job);
		if (at >= 0) {
			this.#waiting.splice(at, 1);
			job.resolve({ type: "unable" });
		} else if (this.#running === job) this.#break({ type: "unable" });
	}

	/**
	 * Starts the next request. A growth that takes longer than LONGEST_GROWTH (ms) is refused; without requests for REST
	 * (ms), the worker ends.
	 */
	#next(): void {
		if (this.#running) return;
		clearTimeout(this.#timer);
		const job = this.#waiting.shift();
		if (!job) {
			this.#timer = setTimeout(() => this.#end(), REST);
			return;
		}
		this.#running = job;
		const late = text("growth_too_long", { seconds: LONGEST_GROWTH / 1000 });
		this.#timer = setTimeout(() => this.#break(refusal(late)), LONGEST_GROWTH);
		try {
			this.#workerFor(job.request.script).postMessage(job.request);
		} catch {
			this.#break({ type: "unable" });
		}
	}

	/** Returns the worker of a build's script; the worker of another build is ended first. */
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

	/** Settles the running job and starts the next one. */
	#answer(answer: SpecimenAnswer): void {
		const job = this.#running;
		this.#running = undefined;
		job?.resolve(answer);
		this.#next();
	}

	/** Ends the worker, if there is one. */
	#end(): void {
		this.#thread?.worker.terminate();
		this.#thread = undefined;
	}
}
