import { beforeAll, describe, expect, it, vi } from "vitest";
import { described } from "../../../../../web/src/models/flower/design/description";
import { assembled, describedIn, designOf } from "../../../../../web/src/models/flower/design/design";
import { model } from "../../../../../web/src/models/flower/index";
import type { FlowerSpecimen } from "../../../../../web/src/models/flower/specimen";
import { fetchTexts } from "../../../../../web/src/models/flower/texts";
import {
	Drafts,
	descriptionsIn,
	designIn,
	type FlowerContext,
} from "../../../../../web/src/models/flower/ui/design/drafts";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import type { NoticeOptions } from "../../../../../web/src/ui/editor_context";

beforeAll(fetchTexts);

/** An editor context with a text, in which nothing grows. */
function contextWith(grammar: string | undefined, specimen: FlowerSpecimen = fromPreset(model)) {
	const state = { model, specimen: { ...specimen, grammar } };
	const take = ({ details = {} }: { details?: object }) => {
		state.specimen = { ...state.specimen, ...details };
	};
	const notify = vi.fn<(title: string, details?: readonly string[], options?: NoticeOptions) => void>();
	const context = { state, edit: take, set: take, settle: () => {}, notify } as unknown as FlowerContext;
	return { context, state, notify };
}

/** Returns the organs with one number changed. */
function withNumber(context: FlowerContext, organ: "petal" | "stamen", key: string, value: number) {
	const design = designIn(context.state.specimen);
	if (!design) throw new Error("no design");
	return descriptionsIn(design).map((each) => (each.organ === organ ? described(each, { [key]: value }) : each));
}

const EDITED = assembled().replace(/#define long=.*/, "#define long=99");

describe("drafts of a design", () => {
	it("begin with the text that is there, where a gesture was left without its end", () => {
		const { context, state } = contextWith(assembled());
		const drafts = new Drafts();
		drafts.edit(context, withNumber(context, "petal", "count", 7));
		// Undone, and written by hand.
		state.specimen = { ...state.specimen, grammar: `/* Mine */\n${assembled()}` };
		drafts.edit(context, withNumber(context, "stamen", "count", 3));
		const design = designOf(state.specimen.grammar ?? "");
		expect(design?.head).toBe("/* Mine */\n");
		expect(design && describedIn(design, "stamen").values.count).toBe(3);
		expect(design && describedIn(design, "petal").values.count).toBe(5);
	});

	it("override slider values, and keep those that they do not change", () => {
		const tulip = fromPreset(model, "designed-tulip");
		const beside = { ...tulip, constants: { length: 600, bend: 2 } };
		const { context, state, notify } = contextWith(undefined, beside);
		const design = designIn(beside)!;
		new Drafts().set(context, described(describedIn(design, "stem"), { length: 100 }));
		expect(state.specimen.constants).toEqual({});
		expect(state.specimen.grammar).toMatch(/^#define length=100 /m);
		expect(state.specimen.grammar).toMatch(/^#define bend=2 /m);
		expect(notify.mock.lastCall?.[1]?.[0]).toMatch(/^#define length=600 /);
		notify.mock.lastCall?.[2]?.act?.run();
		expect(state.specimen.constants).toEqual({});
		expect(state.specimen.grammar).toMatch(/^#define length=600 /m);
	});

	it("continue through a gesture with slider values, and restore them when reverted", () => {
		const beside = { ...fromPreset(model, "designed-tulip"), constants: { length: 600 } };
		const { context, state } = contextWith(undefined, beside);
		const drafts = new Drafts();
		const before = descriptionsIn(designIn(beside)!);
		drafts.edit(context, withNumber(context, "petal", "count", 7));
		drafts.edit(context, withNumber(context, "petal", "count", 9));
		expect(state.specimen.grammar).toMatch(/^#define length=600 /m);
		drafts.edit(context, before);
		expect(state.specimen).toEqual(beside);
	});

	it("keep nothing of a gesture's intermediate states", () => {
		const { context, state } = contextWith(EDITED);
		const drafts = new Drafts();
		const before = withNumber(
			context,
			"stamen",
			"length",
			Number(describedIn(designOf(EDITED)!, "stamen").values.length),
		);
		drafts.edit(context, withNumber(context, "stamen", "length", 40));
		expect(state.specimen.grammar).not.toContain("#define long=99");
		drafts.edit(context, before);
		expect(state.specimen.grammar).toBe(EDITED);
	});

	it("retain the edited lines if the text is still the choice's, and otherwise report that it has changed", () => {
		const lost = () => {
			const all = contextWith(EDITED);
			const design = designOf(EDITED)!;
			new Drafts().set(all.context, described(describedIn(design, "stamen"), { length: 40 }));
			expect(all.notify).toHaveBeenCalledTimes(1);
			return { ...all, keep: () => all.notify.mock.calls[0][2]?.act?.run() };
		};
		const still = lost();
		still.keep();
		expect(still.state.specimen.grammar).toContain("#define long=99");
		expect(still.notify).toHaveBeenCalledTimes(1);

		const changed = lost();
		const newer = `/* Newer */\n${changed.state.specimen.grammar}`;
		changed.state.specimen = { ...changed.state.specimen, grammar: newer };
		changed.keep();
		expect(changed.state.specimen.grammar).toBe(newer);
		expect(changed.notify.mock.lastCall?.[0]).toBe("Your lines could not be restored");

		const other = lost();
		const { grammar } = other.state.specimen;
		other.state.specimen = { ...fromPreset(model, "petal"), grammar };
		other.keep();
		expect(other.state.specimen.grammar).toBe(grammar);
	});
});
