import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { PageGrowOptions } from "../../../web/src/app/core_grower";
import { PageGrowth } from "../../../web/src/app/growing";
import type { Studio } from "../../../web/src/app/studio";
import { CoreError, CoreTrap, Superseded, UnsupportedError } from "../../../web/src/core/errors";
import type { PageModel } from "../../../web/src/models/page_model";
import type { Plant } from "../../../web/src/plant/plant";
import { specimenFromPreset } from "../bunch";
import { toy } from "../toy";
import { bunchModel } from "./context";

const specimen = (seed: number) => ({ ...specimenFromPreset("duku"), seed });
const bunch = (fingerprint: string) => ({ fingerprint }) as Plant;

describe("growing", () => {
	interface Call {
		resolve(grown: Plant): void;
		reject(reason: unknown): void;
		signal: AbortSignal;
		sketched: boolean;
	}
	let calls: Call[];
	const studio = {
		state: {
			shown: undefined as { model: PageModel } | undefined,
			model: bunchModel as PageModel,
			specimen: specimen(1),
		},
		growAgain: vi.fn(),
		grew: vi.fn(),
		caughtUp: vi.fn(),
		setGrowing: vi.fn(),
		notify: vi.fn(),
		fail: vi.fn(),
	};
	let growing: PageGrowth;

	beforeEach(() => {
		vi.useFakeTimers();
		vi.clearAllMocks();
		calls = [];
		studio.state.shown = { model: bunchModel };
		studio.state.model = bunchModel;
		const client = {
			grow: (_model: unknown, _specimen: unknown, { signal, sketched = false }: PageGrowOptions = {}) =>
				new Promise<Plant>((resolve, reject) => {
					calls.push({ resolve, reject, signal: signal as AbortSignal, sketched });
					signal?.addEventListener("abort", () => reject(signal.reason));
				}),
		};
		growing = new PageGrowth(client, () => studio as unknown as Studio);
	});
	afterEach(() => vi.useRealTimers());

	it("passes the plant and its specimen to the studio", async () => {
		const done = growing.grow(bunchModel, specimen(1));
		calls[0].resolve(bunch("a"));
		await done;
		expect(studio.grew).toHaveBeenCalledExactlyOnceWith(bunch("a"), specimen(1));
		await vi.advanceTimersByTimeAsync(1000);
		expect(studio.setGrowing).not.toHaveBeenCalledWith(true);
	});

	it("uses sketches until the first picture, then grows again models with a sketch", () => {
		for (const sketched of [true, false]) {
			void growing.grow(bunchModel, specimen(1));
			expect(calls.at(-1)?.sketched).toBe(sketched);
			growing.finish();
		}
		expect(studio.growAgain).not.toHaveBeenCalled();
		studio.state.model = { ...bunchModel, sketch: async () => {} } as PageModel;
		growing.finish();
		expect(studio.growAgain).toHaveBeenCalledOnce();
	});

	it("shows every response of a drag, but never an older one after a newer one", async () => {
		const all = [
			growing.grow(bunchModel, specimen(1)),
			growing.grow(bunchModel, specimen(2)),
			growing.grow(bunchModel, specimen(3)),
		];
		calls[0].resolve(bunch("a"));
		calls[2].resolve(bunch("c"));
		await vi.advanceTimersByTimeAsync(0);
		calls[1].resolve(bunch("b"));
		await Promise.all(all);
		expect(studio.grew.mock.calls.map(([{ fingerprint }]) => fingerprint)).toEqual(["a", "c"]);
		expect(studio.caughtUp).toHaveBeenCalledOnce();
		expect(studio.caughtUp.mock.invocationCallOrder[0]).toBeGreaterThan(studio.grew.mock.invocationCallOrder[1]);
	});

	it("shows progress when one response takes long, not when a drag does", async () => {
		for (let seed = 1; seed <= 10; seed++) {
			void growing.grow(bunchModel, specimen(seed));
			await vi.advanceTimersByTimeAsync(100);
			calls[seed - 1].resolve(bunch(`${seed}`));
		}
		await vi.advanceTimersByTimeAsync(0);
		expect(studio.setGrowing).not.toHaveBeenCalledWith(true);
		void growing.grow(bunchModel, specimen(11));
		await vi.advanceTimersByTimeAsync(250);
		expect(studio.setGrowing).toHaveBeenLastCalledWith(true);
		calls[10].resolve(bunch("11"));
		await vi.advanceTimersByTimeAsync(0);
		expect(studio.setGrowing).toHaveBeenLastCalledWith(false);
	});

	it("cancels with one notice, and grows again afterwards", async () => {
		const first = growing.grow(bunchModel, specimen(1));
		const second = growing.grow(bunchModel, specimen(2));
		growing.cancel();
		await Promise.all([first, second]);
		expect(studio.notify).toHaveBeenCalledOnce();
		expect(studio.notify.mock.lastCall?.[0]).toMatch(/cancelled/);
		expect(studio.caughtUp).toHaveBeenCalledOnce();
		const third = growing.grow(bunchModel, specimen(3));
		expect(calls[2].signal.aborted).toBe(false);
		calls[2].resolve(bunch("c"));
		await third;
		expect(studio.grew).toHaveBeenCalledOnce();
	});

	it("does not report superseded growths, nor errors of outdated ones", async () => {
		const first = growing.grow(bunchModel, specimen(1));
		const second = growing.grow(bunchModel, specimen(2));
		calls[0].reject(new CoreError("limit", "too large"));
		calls[1].reject(new Superseded());
		await Promise.all([first, second]);
		expect(studio.notify).not.toHaveBeenCalled();
		expect(studio.fail).not.toHaveBeenCalled();
	});

	it.each([
		[new CoreError("syntax", "unexpected )", 3, 7), "notify", "Line 3, column 7 of the grammar: unexpected )"],
		[new CoreError("limit", "too large"), "notify", "too large"],
		[new CoreTrap("unreachable"), "notify", "Still showing the last plant."],
		[new UnsupportedError("fetch", "no core"), "fail", "no core"],
		[new Error("odd"), "fail", "odd"],
	] as const)("reports %o while a bunch is in view", async (error, how, words) => {
		const done = growing.grow(bunchModel, specimen(1));
		calls[0].reject(error);
		await done;
		expect(studio[how]).toHaveBeenCalledOnce();
		expect(JSON.stringify(studio[how].mock.lastCall)).toContain(words);
	});

	it("says whether a plant is still shown", async () => {
		const failing = () => calls[calls.length - 1].reject(new CoreTrap("unreachable"));
		const beside = growing.grow(toy as unknown as PageModel, specimen(1));
		failing();
		await beside;
		expect(studio.notify.mock.lastCall?.[1]).toEqual([
			"Still showing the last plant. Change any setting to try again.",
		]);
		studio.state.shown = undefined;
		const first = growing.grow(toy as unknown as PageModel, specimen(1));
		failing();
		await first;
		expect(studio.fail.mock.lastCall?.[0].details).toEqual(["Nothing has grown yet. Change any setting to try again."]);
	});

	it.each([
		[new CoreError("syntax", "unexpected )", 3, 7), ["other"], "Line 3, column 7 of the grammar: unexpected )"],
		[new CoreTrap("unreachable"), ["again", "other"], "Nothing has grown yet."],
		[new UnsupportedError("fetch", "no core"), ["again"], "no core"],
	] as const)("shows a failure in place of the first bunch: %o", async (error, remedies, words) => {
		studio.state.shown = undefined;
		const done = growing.grow(bunchModel, specimen(1));
		calls[0].reject(error);
		await done;
		expect(studio.notify).not.toHaveBeenCalled();
		expect(studio.fail.mock.lastCall?.[0]).toMatchObject({ remedies });
		const message = JSON.stringify(studio.fail.mock.lastCall);
		expect(message).toContain(words);
		expect(message).not.toContain("last plant");
	});

	it("does not mention a last plant when the first growth is cancelled", async () => {
		studio.state.shown = undefined;
		const done = growing.grow(bunchModel, specimen(1));
		growing.cancel();
		await done;
		expect(studio.notify).not.toHaveBeenCalled();
		expect(studio.fail.mock.lastCall?.[0]).toMatchObject({
			title: "Growing was cancelled",
			remedies: ["again", "other"],
		});
	});
});
