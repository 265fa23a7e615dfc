/**
 * Reads a derivation trace in windows, on demand, and never returns a window of another step than the current one. One
 * request runs at a time; of the later ones, only the newest waits.
 */
import { Superseded } from "../core/errors";
import type { DerivationTrace, TraceRequest } from "../plant/derivation_trace";

/** Modules per window. */
export const WINDOW = 600;
/** Windows begin at multiples of this, so that cached windows are found again. */
const GRID = 200;
/** Largest number of cached windows. */
const MAX_CACHED = 24;
/** Delay until a request that is no longer needed is aborted with its worker, milliseconds. */
const ABANDON_DELAY = 200;

/** Requests a window of the trace from the core. */
export type RequestTrace = (request: TraceRequest, signal: AbortSignal) => Promise<DerivationTrace>;

/** Module that the window must contain. */
export interface WindowTarget {
	/** Step; undefined for the last step. */
	readonly step: number | undefined;
	/** Index of a module inside the window. */
	readonly about: number;
}

/** Returns the beginning of the window around a module, centred if possible. */
export function windowAbout(about: number, length: number): number {
	const middle = Math.round((about - WINDOW / 2) / GRID) * GRID;
	const last = Math.max(0, Math.ceil((length - WINDOW) / GRID) * GRID);
	return Math.max(0, Math.min(middle, last));
}

/** A running request. */
interface Running {
	readonly request: TraceRequest;
	readonly requestTrace: RequestTrace;
	readonly wanted: WindowTarget;
	readonly from: number;
	readonly ending: AbortController;
	/** Aborts the request once it is no longer needed. */
	timer?: ReturnType<typeof setTimeout> | undefined;
}

export class TraceReader {
	readonly #changed: () => void;
	#requestTrace: RequestTrace | undefined;
	#cached = new Map<string, DerivationTrace>();
	/** Modules of each step's string; stays while another document's is loading. */
	#counts: Uint32Array | undefined;
	#wanted: WindowTarget = { step: undefined, about: 0 };
	#page: DerivationTrace | undefined;
	#stale = false;
	#fault: string | undefined;
	#running: Running | undefined;

	/** @param changed called when the displayed state has changed */
	constructor(changed: () => void) {
		this.#changed = changed;
	}

	/** The requested window once loaded; until then another window of the same step. */
	get page(): DerivationTrace | undefined {
		return this.#page;
	}

	/** Whether `page` belongs to an earlier document. */
	get stale(): boolean {
		return this.#stale;
	}

	/** Modules of each step's string, as last received. */
	get counts(): Uint32Array | undefined {
		return this.#counts;
	}

	/** Error message if no trace can be shown. */
	get fault(): string | undefined {
		return this.#fault;
	}

	/** The requested step; undefined until the last step is known. */
	get step(): number | undefined {
		const last = this.#counts ? this.#counts.length - 1 : undefined;
		return last === undefined ? this.#wanted.step : Math.min(this.#wanted.step ?? last, last);
	}

	/** Begins to read another document's trace and clears the cache. */
	begin(requestTrace: RequestTrace): void {
		this.#requestTrace = requestTrace;
		this.#cached = new Map();
		this.#stale = this.#page !== undefined;
		this.#update();
	}

	/** Requests the window around a module. */
	want(wanted: WindowTarget): void {
		this.#wanted = wanted;
		this.#fault = undefined;
		if (this.#page && this.#page.step !== this.step) this.#page = undefined;
		this.#update();
		this.#changed();
	}

	/** Aborts the running request; no further ones are made. */
	close(): void {
		this.#requestTrace = undefined;
		const running = this.#running;
		if (!running) return;
		this.#end(running);
		running.ending.abort();
	}

	/**
	 * Aborts a running request that is no longer needed after a delay; if it finishes earlier, its window is cached.
	 */
	#abandon(running: Running): void {
		const left = ABANDON_DELAY - (performance.now() - running.from);
		running.timer ??= setTimeout(() => {
			if (this.#running !== running) return;
			running.ending.abort();
			this.#running = undefined;
			this.#update();
		}, left);
	}

	/** Cancels the delayed abort of a running request that is needed again. */
	#resume(running: Running): void {
		clearTimeout(running.timer);
		running.timer = undefined;
	}

	/** Returns the request for the window around the wanted module. */
	#nextRequest(): TraceRequest {
		const { step, about } = this.#wanted;
		const length = this.#counts?.[this.step ?? 0] ?? 0;
		// If the step is unknown, the last step is requested.
		return { step: step ?? MANY, first: windowAbout(about, length), count: WINDOW };
	}

	/**
	 * Shows the wanted window from the cache, or requests it. A running request for the same window goes on; one for
	 * another is aborted after a delay, and then this is called again.
	 */
	#update(): void {
		const requestTrace = this.#requestTrace;
		if (!requestTrace) return;
		const request = this.#nextRequest();
		const known = this.step === undefined ? undefined : this.#cached.get(keyOf({ ...request, step: this.step }));
		if (known) {
			this.#page = known;
			this.#stale = false;
			return;
		}
		if (this.#running) {
			if (this.#running.requestTrace === requestTrace && keyOf(this.#running.request) === keyOf(request))
				this.#resume(this.#running);
			else this.#abandon(this.#running);
			return;
		}
		const running: Running = {
			request,
			requestTrace,
			wanted: this.#wanted,
			from: performance.now(),
			ending: new AbortController(),
		};
		this.#running = running;
		requestTrace(request, running.ending.signal).then(
			(trace) => this.#receive(running, trace),
			(error: unknown) => this.#fail(running, error),
		);
	}

	/** Takes a trace that has arrived, unless the document has changed since it was requested. */
	#receive(running: Running, trace: DerivationTrace): void {
		const { request, requestTrace, wanted } = running;
		this.#end(running);
		if (this.#requestTrace !== requestTrace) {
			this.#update();
			return;
		}
		this.#counts = trace.counts;
		this.#fault = undefined;
		// The previous document's string was longer.
		const beyond = trace.modules.length === 0 && (request.first ?? 0) > 0;
		if (!beyond) this.#cache(trace);
		// Windows of a step that is no longer requested are not shown.
		if (!beyond && trace.step === this.step) {
			this.#page = trace;
			this.#stale = false;
		} else if (this.#page?.step !== this.step) this.#page = undefined;
		if (wanted !== this.#wanted || beyond) this.#update();
		this.#changed();
	}

	/**
	 * Handles the failure of a request. If another window or document is wanted by now, or another offscreen request
	 * replaced this one before it began, requests the wanted window; else reports the error as `fault`.
	 */
	#fail(running: Running, error: unknown): void {
		// An aborted request is ignored.
		if (this.#running !== running) return;
		this.#end(running);
		// Another offscreen request replaced this one before it began.
		const again = error instanceof Superseded;
		if (again || this.#requestTrace !== running.requestTrace || this.#wanted !== running.wanted) this.#update();
		else {
			this.#fault = error instanceof Error ? error.message : String(error);
			this.#page = undefined;
			// Without any received window the steps are unknown.
			if (this.#cached.size === 0) this.#counts = undefined;
		}
		this.#changed();
	}

	/** Ends a request that has been answered or aborted: removes its timer. */
	#end(running: Running): void {
		clearTimeout(running.timer);
		if (this.#running === running) this.#running = undefined;
	}

	/** Caches a window as the newest, and drops the oldest of too many. */
	#cache(trace: DerivationTrace): void {
		const key = keyOf(trace);
		this.#cached.delete(key);
		this.#cached.set(key, trace);
		if (this.#cached.size > MAX_CACHED) this.#cached.delete(this.#cached.keys().next().value ?? "");
	}
}

/** A step beyond all steps. */
const MANY = 0xffffffff;

/** Returns the cache key of a window. */
const keyOf = ({ step, first = 0 }: { readonly step: number; readonly first?: number }) => `${step} ${first}`;
