/**
 * Threads that answer, each one question after the other. What takes longer than it may is ended with its thread, and another takes
 * that one's place: a growth in WebAssembly cannot be interrupted otherwise.
 */
import { Refused } from "../refused";
import type { Question, Reply } from "./messages";

/** What is used of a `worker_threads` Worker; tests give another. */
export interface Thread {
	postMessage(question: Question): void;
	on(event: "message", listener: (reply: Reply) => void): unknown;
	on(event: "error" | "exit", listener: () => void): unknown;
	terminate(): Promise<unknown>;
}

export interface ThreadsOptions {
	start(): Thread;
	/** How many at once. */
	readonly threads: number;
	/** After so long an answer is given up, milliseconds. */
	readonly patience: number;
	/** So many questions wait at the most. */
	readonly waiting: number;
}

const ENDS = "the service ends";

type Asked = Omit<Question, "id">;

interface Job {
	readonly asked: Asked;
	readonly answered: (reply: Reply) => void;
	readonly failed: (error: Error) => void;
}

interface Seat {
	thread: Thread | undefined;
	job: Job | undefined;
	/** Ends the job that takes too long. */
	timer: ReturnType<typeof setTimeout> | undefined;
}

export class Threads {
	readonly #options: ThreadsOptions;
	readonly #seats: Seat[];
	readonly #queue: Job[] = [];
	#asked = 0;
	#closed = false;

	constructor(options: ThreadsOptions) {
		this.#options = options;
		this.#seats = Array.from({ length: options.threads }, () => ({
			thread: undefined,
			job: undefined,
			timer: undefined,
		}));
	}

	/** @throws Refused where too many wait, it takes too long, or the thread broke */
	ask(asked: Asked): Promise<Reply> {
		return new Promise((answered, failed) => {
			if (this.#closed) throw new Refused(503, ENDS);
			if (this.#queue.length >= this.#options.waiting)
				throw new Refused(503, "too many ask at once; try again in a moment", { "retry-after": "5" });
			this.#queue.push({ asked, answered, failed });
			this.#next();
		});
	}

	async close(): Promise<void> {
		this.#closed = true;
		for (const { failed } of this.#queue.splice(0)) failed(new Refused(503, ENDS));
		await Promise.all(this.#seats.map((seat) => this.#leave(seat, ENDS)));
	}

	#next(): void {
		const seat = this.#seats.find(({ job }) => !job);
		const job = seat && this.#queue.shift();
		if (!job) return;
		seat.job = job;
		seat.thread ??= this.#start(seat);
		const { patience } = this.#options;
		const late = `it took more than ${patience / 1000} s; ask for a smaller plant or a smaller file`;
		seat.timer = setTimeout(() => void this.#leave(seat, late), patience);
		seat.thread.postMessage({ id: ++this.#asked, ...job.asked });
	}

	#start(seat: Seat): Thread {
		const thread = this.#options.start();
		thread.on("message", (reply) => {
			if (seat.thread === thread) this.#end(seat, ({ answered }) => answered(reply));
		});
		const gone = () => {
			if (seat.thread === thread) void this.#leave(seat, "the thread that grew it broke");
		};
		thread.on("error", gone);
		thread.on("exit", gone);
		return thread;
	}

	/** Ends a thread, and with it what it does. */
	async #leave(seat: Seat, why: string): Promise<void> {
		const { thread } = seat;
		seat.thread = undefined;
		this.#end(seat, ({ failed }) => failed(new Refused(503, why)));
		await thread?.terminate();
	}

	#end(seat: Seat, tell: (job: Job) => void): void {
		const { job } = seat;
		clearTimeout(seat.timer);
		seat.job = undefined;
		if (job) tell(job);
		this.#next();
	}
}
