import { afterAll, beforeAll, describe, expect, it, vi } from "vitest";
import type { StudioPart } from "../../../../web/src/app/parts/studio_part";
import { Studio } from "../../../../web/src/app/studio";
import { FIRST_VISIT } from "../../../../web/src/app/ui_state";
import { age } from "../../../../web/src/models/bunch/ui/age";
import { stems } from "../../../../web/src/models/bunch/ui/stems";
import type { PageModel } from "../../../../web/src/models/page_model";
import { PLAY } from "../../../../web/src/ui/life_player";
import { specimenFromPreset } from "../../bunch";
import { sampleBunch } from "../../models/bunch/sample_bunch";
import { toy } from "../../toy";
import { bunchModel } from "../context";

const PARTS = {
	bars: () => import("../../../../web/src/app/parts/bars").then(({ Bars }) => Bars),
	download: () => import("../../../../web/src/app/parts/download_sheet").then(({ DownloadSheet }) => DownloadSheet),
	drop: () => import("../../../../web/src/app/parts/drop").then(({ Drop }) => Drop),
	editors: () => import("../../../../web/src/app/parts/editors").then(({ Editors }) => Editors),
	gallery: () => import("../../../../web/src/app/parts/gallery").then(({ Gallery }) => Gallery),
	help: () => import("../../../../web/src/app/help/help").then(({ Help }) => Help),
	history: () => import("../../../../web/src/app/parts/history_bar").then(({ HistoryBar }) => HistoryBar),
	life: () => import("../../../../web/src/ui/life_bar").then(({ LifeBar }) => LifeBar),
	notices: () => import("../../../../web/src/app/parts/notices").then(({ Notices }) => Notices),
	panel: () => import("../../../../web/src/app/parts/panel").then(({ Panel }) => Panel),
	readout: () => import("../../../../web/src/app/parts/readout").then(({ Readout }) => Readout),
	shortcuts: () => import("../../../../web/src/app/help/shortcut_sheet").then(({ ShortcutSheet }) => ShortcutSheet),
	share: () => import("../../../../web/src/app/parts/share_bar").then(({ ShareBar }) => ShareBar),
	speaker: () => import("../../../../web/src/app/parts/speaker").then(({ Speaker }) => Speaker),
	stage: () => import("../../../../web/src/app/parts/stage").then(({ StagePart }) => StagePart),
	variation: () => import("../../../../web/src/app/parts/variation").then(({ Variation }) => Variation),
	views: () => import("../../../../web/src/app/parts/view_switch").then(({ ViewSwitch }) => ViewSwitch),
};
type Name = keyof typeof PARTS;

/** A part outside a page: its drawing is discarded. */
interface Probe {
	context: Studio;
	requestUpdate(): void;
	connectedCallback(): void;
	performUpdate(): void;
	render(): unknown;
}

const parts = new Map<Name, { probe: Probe; requestUpdate: ReturnType<typeof vi.fn> }>();
const studio = new Studio(
	{ model: bunchModel, specimen: specimenFromPreset(), ui: FIRST_VISIT, systemDark: false },
	{ grow: vi.fn(), cancel: vi.fn(), measure: vi.fn(), growOffscreen: vi.fn(), settled: vi.fn(), remember: vi.fn() },
);

/** The parts that request an update after a change; draws all of them afterwards, as the page would. */
async function followers(change: () => unknown): Promise<string[]> {
	for (const { requestUpdate } of parts.values()) requestUpdate.mockClear();
	await change();
	await Promise.resolve();
	const updated = [...parts]
		.filter(([, { requestUpdate }]) => requestUpdate.mock.calls.length > 0)
		.map(([name]) => name);
	for (const { probe } of parts.values()) probe.render();
	return updated;
}

const shown = () => ({ ...sampleBunch(5), measures: new Float32Array([1]) });
const previewBunch = () => ({ ...sampleBunch(5), measures: undefined });
const aged = (value: number) => studio.edit({ parameters: { age: value } }, PLAY);

beforeAll(async () => {
	vi.stubGlobal("window", new EventTarget());
	vi.stubGlobal("ResizeObserver", class {});
	const tools = vi.waitFor(() => expect(studio.state.modelUi).toBeDefined());
	await tools;
	for (const [name, load] of Object.entries(PARTS) as [Name, () => Promise<new () => StudioPart>][]) {
		const probe = new (await load())() as unknown as Probe;
		probe.performUpdate = () => {};
		const requestUpdate = vi.fn();
		probe.requestUpdate = requestUpdate;
		Object.assign(probe, { context: studio, life: name === "life" ? LIFE : undefined, play: age });
		probe.connectedCallback();
		parts.set(name, { probe, requestUpdate });
	}
	studio.grew(shown(), studio.state.specimen);
	await followers(() => aged(10));
});
afterAll(() => vi.unstubAllGlobals());

const { LIFE } = await import("../../../../web/src/models/bunch/ui/age");

describe("while a life plays", () => {
	it("only the life's bar is drawn for a frame", async () => {
		expect(await followers(() => aged(20))).toEqual(["life"]);
	});

	it("a preview is drawn by the views, the read-out and the speaker", async () => {
		await followers(() => studio.grew(previewBunch(), studio.state.specimen));
		const preview = await followers(() => studio.grew(previewBunch(), studio.state.specimen));
		expect(preview).toEqual(["editors", "readout", "speaker", "stage"]);
	});

	it("several changes are checked once", async () => {
		const shows = vi.spyOn(parts.get("history")?.probe as unknown as { shows(): unknown[] }, "shows");
		await followers(() => [30, 31, 32].map(aged));
		// Once for the changes, once for the drawing.
		expect(shows).toHaveBeenCalledTimes(2);
		shows.mockRestore();
	});
});

describe("a part of the page follows", () => {
	const document = ["editors", "panel", "readout"];
	it.each<[what: string, change: () => unknown, followed: readonly string[]]>([
		["the end of a drag", () => studio.settle(), []],
		["a step back", () => studio.undo(), ["history", "life"]],
		["a parameter", () => studio.set({ parameters: { l: 300 } }), ["history", ...document]],
		["a colour", () => studio.set({ look: { skin: "112233" } }), document],
		["the seed", () => studio.newVariation(), [...document, "variation"]],
		["the theme", () => studio.setUi({ theme: "dark" }), ["gallery", "help", "share"]],
		["a group that is opened", () => studio.setGroup("colours", true), ["panel"]],
		["letters that are no keys", () => studio.setUi({ letters: false }), ["shortcuts"]],
		["the view of a phone", () => studio.setUi({ view: "front" }), ["editors", "views"]],
		["a tool that is switched on", () => studio.setToolState(stems, true), ["editors", "panel", "stage"]],
		[
			"a life's speed",
			() => studio.setToolState(age, { playing: false, speed: 2 }),
			["editors", "life", "panel", "stage"],
		],
		["a notice", () => studio.notify("Something"), ["notices"]],
		["a failure", () => studio.fail({ title: "No", details: [], remedies: [] }), ["stage"]],
		[
			"what is measured at rest",
			() => studio.grew(shown(), studio.state.specimen),
			["editors", "readout", "speaker", "stage"],
		],
		["a growth that takes long", () => studio.setGrowing(true), ["stage"]],
		["what there is to save", () => studio.showPicture(async () => new Blob()), ["download"]],
		["models that have come", () => studio.list([bunchModel, toy as unknown as PageModel]), ["gallery"]],
		["a preset", () => studio.choosePreset("winged-cylindrical"), ["gallery", "history", "variation", ...document]],
	])("%s", async (_, change, followed) => {
		expect((await followers(change)).sort()).toEqual([...followed].sort());
	});

	it("another model, and its tools once they are loaded", async () => {
		parts.delete("life"); // The page has taken it away by then.
		const all = ["bars", "editors", "gallery", "help", "panel", "readout", "shortcuts", "stage", "views"];
		expect(await followers(() => studio.choosePreset("plain", toy as unknown as PageModel))).toEqual(
			expect.arrayContaining(all),
		);
		const tools = vi.waitFor(() => expect(studio.state.modelUi).toBeDefined());
		const late = ["editors", "help", "panel", "readout", "shortcuts", "stage", "views"];
		expect(await followers(() => tools)).toEqual(expect.arrayContaining(late));
	});
});
