/**
 * Reads a derivation window by window, as one asks for it: nothing of another step than the one asked for is ever given. One question
 * is under way at a time; of those that come meanwhile the newest waits.
 */
import { Superseded } from "../core/errors";
import type { DerivationTrace, TraceRequest } from "../plant/derivation_trace";

/** Modules of a window. */
export const WINDOW = 600;
/** Windows begin at multiples of this, so that what was read is found again. */
const GRID = 200;
/** Windows that are kept. */
const MOST_KEPT = 24;
/** A question that nobody waits for any more is ended after so many milliseconds, with its worker. */
const PATIENCE = 200;

/** Asks the core. */
export type RequestTrace = (asked: TraceRequest, signal: AbortSignal) => Promise<DerivationTrace>;

/** What is wanted: about a module of a step's string. */
export interface Wanted {
	/** That of the last step where undefined. */
	readonly step: number | undefined;
	/** Index of the module that is to be in the window. */
	readonly about: number;
}

/** The beginning of the window that has a module in it, with as much before as behind where there is. */
export function windowAbout(about: number, length: number): number {
	const middle = Math.round((about - WINDOW / 2) / GRID) * GRID;
	const last = Math.max(0, Math.ceil((length - WINDOW) / GRID) * GRID);
	return Math.max(0, Math.min(middle, last));
}

/** A question under way. */
interface Running {
	readonly asked: TraceRequest;
	readonly ask: RequestTrace;
	readonly wanted: Wanted;
	readonly from: number;
	readonly ending: AbortController;
	/** Ends it, once nobody waits for it any more. */
	timer?: ReturnType<typeof setTimeout> | undefined;
}

export class TraceReader {
	readonly #changed: () => void;
	#ask: RequestTrace | undefined;
	#kept = new Map<string, DerivationTrace>();
	/** What is known of the whole; it stays while another document's is awaited. */
	#counts: Uint32Array | undefined;
	#wanted: Wanted = { step: undefined, about: 0 };
	#page: DerivationTrace | undefined;
	#stale = false;
	#fault: string | undefined;
	#running: Running | undefined;

	/** @param changed called when there is something else to show */
	constructor(changed: () => void) {
		this.#changed = changed;
	}

	/** The window that is wanted, as soon as it is there; of the same step another one meanwhile. */
	get page(): DerivationTrace | undefined {
		return this.#page;
	}

	/** Whether `page` is of a document before this one. */
	get stale(): boolean {
		return this.#stale;
	}

	/** Modules of each step's string, as last told. */
	get counts(): Uint32Array | undefined {
		return this.#counts;
	}

	/** Why nothing is told. */
	get fault(): string | undefined {
		return this.#fault;
	}

	/** The step that is wanted; undefined until it is known which the last is. */
	get step(): number | undefined {
		const last = this.#counts ? this.#counts.length - 1 : undefined;
		return last === undefined ? this.#wanted.step : Math.min(this.#wanted.step ?? last, last);
	}

	/** Another document: what was read is of none any more. */
	begin(ask: RequestTrace): void {
		this.#ask = ask;
		this.#kept = new Map();
		this.#stale = this.#page !== undefined;
		this.#go();
	}

	want(wanted: Wanted): void {
		this.#wanted = wanted;
		this.#fault = undefined;
		if (this.#page && this.#page.step !== this.step) this.#page = undefined;
		this.#go();
		this.#changed();
	}

	/** Ends what is under way. */
	close(): void {
		this.#ask = undefined;
		const running = this.#running;
		if (!running) return;
		this.#end(running);
		running.ending.abort();
	}

	/** What runs for long and is wanted no more ends; what ends soon is kept. */
	#abandon(running: Running): void {
		const left = PATIENCE - (performance.now() - running.from);
		running.timer ??= setTimeout(() => {
			if (this.#running !== running) return;
			running.ending.abort();
			this.#running = undefined;
			this.#go();
		}, left);
	}

	/** What was wanted no more is wanted again. */
	#await(running: Running): void {
		clearTimeout(running.timer);
		running.timer = undefined;
	}

	#asked(): TraceRequest {
		const { step, about } = this.#wanted;
		const length = this.#counts?.[this.step ?? 0] ?? 0;
		// Of a step that nothing is known of the last is told.
		return { step: step ?? MANY, first: windowAbout(about, length), count: WINDOW };
	}

	#go(): void {
		const ask = this.#ask;
		if (!ask) return;
		const asked = this.#asked();
		const known = this.step === undefined ? undefined : this.#kept.get(keyOf({ ...asked, step: this.step }));
		if (known) {
			this.#page = known;
			this.#stale = false;
			return;
		}
		if (this.#running) {
			if (this.#running.ask === ask && keyOf(this.#running.asked) === keyOf(asked)) this.#await(this.#running);
			else this.#abandon(this.#running);
			return;
		}
		const running: Running = {
			asked,
			ask,
			wanted: this.#wanted,
			from: performance.now(),
			ending: new AbortController(),
		};
		this.#running = running;
		ask(asked, running.ending.signal).then(
			(trace) => this.#answered(running, trace),
			(error: unknown) => this.#failed(running, error),
		);
	}

	#answered(running: Running, trace: DerivationTrace): void {
		const { asked, ask, wanted } = running;
		this.#end(running);
		if (this.#ask !== ask) {
			this.#go();
			return;
		}
		this.#counts = trace.counts;
		this.#fault = undefined;
		// The string of another document was longer.
		const beyond = trace.modules.length === 0 && (asked.first ?? 0) > 0;
		if (!beyond) this.#keep(trace);
		// Of another step than the one that is wanted by now nothing is shown.
		if (!beyond && trace.step === this.step) {
			this.#page = trace;
			this.#stale = false;
		} else if (this.#page?.step !== this.step) this.#page = undefined;
		if (wanted !== this.#wanted || beyond) this.#go();
		this.#changed();
	}

	#failed(running: Running, error: unknown): void {
		// What was ended is not wanted any more.
		if (this.#running !== running) return;
		this.#end(running);
		// Something else that is asked for aside took its place before it had begun.
		const again = error instanceof Superseded;
		if (again || this.#ask !== running.ask || this.#wanted !== running.wanted) this.#go();
		else {
			this.#fault = error instanceof Error ? error.message : String(error);
			this.#page = undefined;
			// Of a document that nothing was told of the steps are not known.
			if (this.#kept.size === 0) this.#counts = undefined;
		}
		this.#changed();
	}

	#end(running: Running): void {
		clearTimeout(running.timer);
		if (this.#running === running) this.#running = undefined;
	}

	#keep(trace: DerivationTrace): void {
		const key = keyOf(trace);
		this.#kept.delete(key);
		this.#kept.set(key, trace);
		if (this.#kept.size > MOST_KEPT) this.#kept.delete(this.#kept.keys().next().value ?? "");
	}
}

/** A step beyond all. */
const MANY = 0xffffffff;

const keyOf = ({ step, first = 0 }: { readonly step: number; readonly first?: number }) => `${step} ${first}`;
