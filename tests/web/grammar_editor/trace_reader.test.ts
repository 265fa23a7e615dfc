import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Superseded } from "../../../web/src/core/errors";
import { TraceReader, WINDOW, windowAbout } from "../../../web/src/grammar_editor/trace_reader";
import type { DerivationTrace, TraceRequest } from "../../../web/src/plant/derivation_trace";

/** A derivation whose strings double: 1, 2, 4 … modules. */
function traced({ step, first = 0, count = WINDOW }: TraceRequest, steps = 12): DerivationTrace {
	const counts = Uint32Array.from({ length: steps + 1 }, (_, index) => 2 ** index);
	const at = Math.min(step, steps);
	const length = Math.max(0, Math.min(count, counts[at] - first));
	const modules = Array.from({ length }, (_, index) => ({
		text: `A(${at},${first + index})`,
		values: [],
		children: { first: 2 * (first + index), count: 2 },
		last: { first: 0, count: 1 },
	}));
	return { counts, step: at, first, modules, segments: new Uint32Array(0), organs: new Uint32Array(0) };
}

/** Requests that the test answers by hand. */
function byHand() {
	const requests: {
		request: TraceRequest;
		signal: AbortSignal;
		answer(trace?: DerivationTrace): void;
		fail(error: Error): void;
	}[] = [];
	const requestTrace = (request: TraceRequest, signal: AbortSignal) =>
		new Promise<DerivationTrace>((resolve, reject) => {
			signal.addEventListener("abort", () => reject(signal.reason));
			requests.push({ request, signal, answer: (trace = traced(request)) => resolve(trace), fail: reject });
		});
	return { requestTrace, requests };
}

const settle = () => vi.advanceTimersByTimeAsync(0);
const shown = ({ page }: TraceReader) => page?.modules[0]?.text;

describe("the trace reader", () => {
	beforeEach(() => void vi.useFakeTimers());
	afterEach(() => void vi.useRealTimers());

	async function opened() {
		const { requestTrace, requests } = byHand();
		const changed = vi.fn();
		const reader = new TraceReader(changed);
		reader.begin(requestTrace);
		requests[0].answer();
		await settle();
		return { reader, requestTrace, requests, changed };
	}

	it("begins with the last step", async () => {
		const { reader, changed } = await opened();
		expect(reader.step).toBe(12);
		expect(shown(reader)).toBe("A(12,0)");
		expect(reader.counts).toHaveLength(13);
		expect(changed).toHaveBeenCalled();
	});

	it("never returns a window of another step than requested, however fast requests follow", async () => {
		const { reader, requests } = await opened();
		for (const step of [11, 10, 9, 8, 7]) {
			reader.want({ step, about: 0 });
			expect(reader.page).toBeUndefined();
		}
		// One request runs; of the later ones, only the newest waits.
		expect(requests.map(({ request }) => request.step).slice(1)).toEqual([11]);
		requests[1].answer();
		await settle();
		expect(reader.page).toBeUndefined();
		expect(requests.map(({ request }) => request.step).slice(1)).toEqual([11, 7]);
		requests[2].answer();
		await settle();
		expect(shown(reader)).toBe("A(7,0)");
		// Windows that arrived meanwhile are in the cache.
		reader.want({ step: 11, about: 0 });
		expect(shown(reader)).toBe("A(11,0)");
		expect(requests).toHaveLength(3);
	});

	it("aborts a slow request that is no longer needed", async () => {
		const { reader, requests } = await opened();
		reader.want({ step: 3, about: 0 });
		await vi.advanceTimersByTimeAsync(100);
		reader.want({ step: 4, about: 0 });
		expect(requests[1].signal.aborted).toBe(false);
		await vi.advanceTimersByTimeAsync(150);
		expect(requests[1].signal.aborted).toBe(true);
		expect(requests[2].request.step).toBe(4);
		requests[2].answer();
		await settle();
		expect(shown(reader)).toBe("A(4,0)");
		expect(reader.fault).toBeUndefined();
	});

	it("continues a slow request that is needed again", async () => {
		const { reader, requests } = await opened();
		for (const step of [3, 4, 3]) reader.want({ step, about: 0 });
		await vi.advanceTimersByTimeAsync(1000);
		expect(requests[1].signal.aborted).toBe(false);
		reader.want({ step: 4, about: 0 });
		expect(requests[1].signal.aborted).toBe(false);
		await settle();
		expect(requests[1].signal.aborted).toBe(true);
		// The same window of another document is another request.
		const next = byHand();
		for (const step of [5, 6]) reader.want({ step, about: 0 });
		reader.begin(next.requestTrace);
		reader.want({ step: 4, about: 0 });
		await vi.advanceTimersByTimeAsync(1000);
		expect(requests[2].signal.aborted).toBe(true);
	});

	it("shows another window of the same step until the requested one has loaded", async () => {
		const { reader, requests } = await opened();
		reader.want({ step: 12, about: 3000 });
		expect(shown(reader)).toBe("A(12,0)");
		expect(requests[1].request.first).toBe(2800);
		requests[1].answer();
		await settle();
		expect(reader.page?.first).toBe(2800);
	});

	it("shows the previous document's string as stale until the new one has loaded, and ignores late windows", async () => {
		const { reader, requests } = await opened();
		const next = byHand();
		reader.want({ step: 5, about: 0 });
		reader.begin(next.requestTrace);
		expect(reader.stale).toBe(false); // There is none: step 5 was awaited.
		requests[1].answer({ ...traced({ step: 5 }), modules: [] });
		await settle();
		expect(reader.page).toBeUndefined();
		next.requests[0].answer();
		await settle();
		expect(shown(reader)).toBe("A(5,0)");
		const third = byHand();
		reader.begin(third.requestTrace);
		expect(reader.stale).toBe(true);
		expect(shown(reader)).toBe("A(5,0)");
		third.requests[0].answer();
		await settle();
		expect(reader.stale).toBe(false);
	});

	it("stays within a shorter string, and within a shorter derivation", async () => {
		const { reader, requests } = await opened();
		const next = byHand();
		reader.want({ step: undefined, about: 4000 });
		requests[1].answer();
		await settle();
		reader.begin(next.requestTrace);
		next.requests[0].answer({ ...traced(next.requests[0].request, 3), modules: [] });
		await settle();
		expect(next.requests[1].request.first).toBe(0);
		next.requests[1].answer(traced(next.requests[1].request, 3));
		await settle();
		expect(reader.step).toBe(3);
		expect(shown(reader)).toBe("A(3,0)");
	});

	it("reports an error, and continues with the next request", async () => {
		const { reader, requests } = await opened();
		reader.want({ step: 2, about: 0 });
		requests[1].fail(new Error("The core broke."));
		await settle();
		expect(reader.fault).toBe("The core broke.");
		expect(reader.page).toBeUndefined();
		// The other steps are in reach.
		expect(reader.counts).toHaveLength(13);
		reader.want({ step: 1, about: 0 });
		requests[2].answer();
		await settle();
		expect(reader.fault).toBeUndefined();
		expect(shown(reader)).toBe("A(1,0)");
		const next = byHand();
		reader.begin(next.requestTrace);
		next.requests[0].fail(new Error("The text is wrong."));
		await settle();
		expect(reader.counts).toBeUndefined();
	});

	it("repeats a request that another one replaced", async () => {
		const { reader, requests } = await opened();
		reader.want({ step: 2, about: 0 });
		requests[1].fail(new Superseded());
		await settle();
		expect(reader.fault).toBeUndefined();
		expect(requests.map(({ request }) => request.step).slice(1)).toEqual([2, 2]);
		requests[2].answer();
		await settle();
		expect(shown(reader)).toBe("A(2,0)");
	});
});

it("windows begin at fixed multiples, and contain the requested module", () => {
	for (const length of [1, 599, 601, 5000, 1_000_003]) {
		for (const about of [0, 1, 250, 4999, length - 1].filter((each) => each >= 0 && each < length)) {
			const first = windowAbout(about, length);
			expect(first % 200).toBe(0);
			expect(first).toBeLessThanOrEqual(about);
			expect(first + WINDOW).toBeGreaterThan(about);
			expect(first === 0 || first < length).toBe(true);
		}
	}
});
