import { beforeEach, describe, expect, it, vi } from "vitest";
import { Superseded } from "../../../web/src/core/errors";
import { Derivation } from "../../../web/src/grammar_editor/derivation";
import { DERIVATION, type DerivationState } from "../../../web/src/grammar_editor/derivation_tool";
import { EMPTY_PLANT, type Plant } from "../../../web/src/plant/plant";
import type { Specimen } from "../../../web/src/specimen/specimen";
import type { EditorContext, OffscreenOptions } from "../../../web/src/ui/editor_context";
import { algae } from "./traced_derivation";

const STEPS = 5;

/** Editor context with a plant of the algae; plants of single steps resolve when the test lets them. */
function setUp() {
	const specimen = { model: "grammar" } as Specimen;
	const plants: { readonly options: OffscreenOptions; let(): void; refuse(error: Error): void }[] = [];
	let state: DerivationState = DERIVATION.initial;
	const followers: Pick<Derivation, "follow">[] = [];
	const growOffscreen = vi.fn(async (_from: Specimen, options: OffscreenOptions): Promise<Plant> => {
		const plantAfter = (steps: number) => ({ ...EMPTY_PLANT, trace: algae(options.trace ?? { step: 0 }, steps) });
		if (options.steps === undefined) return plantAfter(STEPS);
		return new Promise((resolve, reject) => {
			plants.push({ options, let: () => resolve(plantAfter(options.steps ?? 0)), refuse: reject });
		});
	});
	const context = {
		state: { grown: { ...EMPTY_PLANT }, grownFrom: specimen },
		growOffscreen,
		toolState: () => state,
		setToolState: (_tool: unknown, next: DerivationState) => {
			state = next;
			// The stepper does the same after drawing.
			queueMicrotask(() => {
				for (const each of followers) each.follow();
			});
		},
	};
	return { context, growOffscreen, plants, followers, tool: () => state };
}

const settle = () => new Promise((resolve) => setTimeout(resolve));

describe("the state of the step viewer", () => {
	let { context, growOffscreen, plants, followers, tool } = setUp();
	let derivation: Derivation;
	beforeEach(async () => {
		({ context, growOffscreen, plants, followers, tool } = setUp());
		derivation = new Derivation(context as unknown as EditorContext, () => {});
		followers.push(derivation);
		await settle();
	});

	const text = () => derivation.page?.modules.map((module) => module.text).join("");
	const to = async (step: number, chosen?: number) => {
		derivation.go(step, chosen);
		await settle();
	};

	it("opens at the last step, whose plant is in view already", () => {
		expect(text()).toBe("ABAABABAABAAB");
		expect(tool().scene).toMatchObject({ step: STEPS, instead: false, grown: context.state.grown });
		expect(plants).toHaveLength(0);
	});

	it("shows the plant of a step once the step's string has loaded", async () => {
		await to(3);
		expect(text()).toBe("ABAAB");
		expect(plants.map(({ options }) => options.steps)).toEqual([3]);
		expect(tool().scene?.step).toBe(STEPS);
		plants[0].let();
		await settle();
		expect(tool().scene).toMatchObject({ step: 3, instead: true });
		await to(STEPS);
		expect(tool().scene).toMatchObject({ step: STEPS, instead: false });
	});

	it("does not show the plant of a step that was left before it had grown", async () => {
		await to(3);
		await to(2);
		plants[0].let();
		await settle();
		expect(tool().scene?.step).toBe(STEPS);
		plants[1].let();
		await settle();
		expect(tool().scene?.step).toBe(2);
	});

	it("shows the document's plant at the last step, and ignores late plants of other steps", async () => {
		await to(3);
		await to(STEPS);
		plants[0].let();
		await settle();
		expect(tool().scene).toMatchObject({ step: STEPS, instead: false });
	});

	it("walks up to the parent and down to the first child", async () => {
		await to(3, 3); // ABA|A|B
		expect(derivation.up()).toBe(true);
		await settle();
		expect([derivation.step, derivation.chosen, text()]).toEqual([2, 2, "ABA"]);
		derivation.up();
		await settle();
		expect([derivation.step, derivation.chosen]).toEqual([1, 1]);
		derivation.choose(0);
		derivation.down();
		await settle();
		expect([derivation.step, derivation.chosen]).toEqual([2, 0]);
		await to(3, 3);
		derivation.down();
		await settle();
		expect([derivation.step, derivation.chosen]).toEqual([4, 5]);
		await to(0, 0);
		expect(derivation.up()).toBe(false);
		await to(STEPS, 4);
		expect(derivation.down()).toBe(false);
	});

	it("follows the chosen module from step to step, and clears the choice after a jump", async () => {
		await to(2, 1);
		derivation.stepBy(1);
		await settle();
		expect(derivation.chosen).toBe(2);
		derivation.stepBy(-1);
		await settle();
		expect(derivation.chosen).toBe(1);
		await to(4);
		expect(derivation.chosen).toBeUndefined();
	});

	it("highlights the module's descendants in the last plant, and the module itself in its own step's plant", async () => {
		derivation.follows = false;
		await to(2, 1); // B of ABA: A, AB, ABA in the last.
		expect(tool().lit).toEqual({ first: 5, count: 3 });
		derivation.follows = true;
		await settle();
		plants[0].let();
		await settle();
		expect(tool().lit).toEqual({ first: 1, count: 1 });
		derivation.point(0);
		expect(tool().lit).toEqual({ first: 0, count: 1 });
		derivation.point(undefined);
		expect(tool().lit).toEqual({ first: 1, count: 1 });
	});

	it("marks the pointed module in the string, and chooses the clicked one", async () => {
		derivation.follows = false;
		await to(2);
		context.setToolState(DERIVATION, { ...tool(), met: { module: 6, step: STEPS, chosen: false } });
		derivation.follow();
		expect(derivation.pointed).toBe(1);
		expect(derivation.chosen).toBeUndefined();
		context.setToolState(DERIVATION, { ...tool(), met: { module: 9, step: STEPS, chosen: true } });
		derivation.follow();
		expect(derivation.chosen).toBe(2);
	});

	it("ignores picks in the previous step's plant while the new one is growing", async () => {
		await to(2);
		plants[0].let();
		await settle();
		await to(3);
		const calls = growOffscreen.mock.calls.length;
		for (const chosen of [false, true]) {
			context.setToolState(DERIVATION, { ...tool(), met: { module: 1, step: 2, chosen } });
			derivation.follow();
			await settle();
			expect([derivation.pointed, derivation.chosen]).toEqual([undefined, undefined]);
		}
		expect(growOffscreen.mock.calls).toHaveLength(calls);
	});

	it("requests the ancestor of a clicked module outside the window", async () => {
		derivation.follows = false;
		await to(2);
		vi.spyOn(derivation, "page", "get").mockReturnValue({ ...algae({ step: 2, first: 0, count: 1 }, STEPS) });
		context.setToolState(DERIVATION, { ...tool(), met: { module: 12, step: STEPS, chosen: true } });
		derivation.follow();
		await settle();
		expect(growOffscreen.mock.lastCall?.[1].trace).toBeDefined();
		expect(derivation.chosen).toBe(2);
	});

	it("replaces string and highlight when the document changes", async () => {
		await to(STEPS, 2);
		expect(tool().lit).toBeDefined();
		Object.assign(context.state, { grown: { ...EMPTY_PLANT }, grownFrom: { model: "grammar" } });
		derivation.follow();
		expect(derivation.stale).toBe(true);
		await settle();
		expect(derivation.stale).toBe(false);
		expect(tool().scene?.from).toBe(context.state.grownFrom);
	});

	it("keeps the last plant in view if a step's plant cannot be grown", async () => {
		await to(1);
		plants[0].refuse(new Error("Too many segments."));
		await settle();
		expect(tool().scene).toMatchObject({ step: STEPS, instead: false });
		derivation.choose(0);
		await settle();
		expect(tool().lit).toEqual({ first: 0, count: 8 });
		// The failed step is not requested again.
		expect(plants).toHaveLength(1);
		await to(2);
		plants[1].refuse(new Superseded());
		await settle();
		expect(tool().scene?.step).toBe(STEPS);
	});

	it("reports why there is no trace, and restores the view", async () => {
		growOffscreen.mockRejectedValueOnce(new Error("The text needs 3 inputs."));
		Object.assign(context.state, { grownFrom: { model: "grammar" } });
		derivation.follow();
		await settle();
		expect(derivation.fault).toBe("The text needs 3 inputs.");
		expect(tool().scene).toBeUndefined();
		derivation.close();
		expect(tool()).toMatchObject({ scene: undefined, lit: undefined, met: undefined });
	});
});
