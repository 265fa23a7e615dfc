import { beforeEach, describe, expect, it, vi } from "vitest";
import { specimenOf, storedSpecimen } from "../../../../web/src/app/session/stored_specimen";
import { restoreHistory, storeHistory } from "../../../../web/src/app/session/tab_history";
import type { Studio } from "../../../../web/src/app/studio";
import { addModel, modelNamed, modelNames } from "../../../../web/src/models/index";
import type { PageModel } from "../../../../web/src/models/page_model";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../../web/src/specimen/specimen";
import { specimenFromPreset } from "../../bunch";
import { toy } from "../../toy";
import { bunchModel, studioWith } from "../context";
import { MemoryStorage } from "../recent/recent_store";

const toyModel = toy as unknown as PageModel;
addModel("toy", async () => toyModel);

const BALL = { points: [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0, 1], triangles: [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2] };

/** The page after a reload: a new studio with the plant of the address. */
async function reloaded(studio: Studio) {
	const { model, specimen } = studio.state;
	const { query, texts } = storedSpecimen(model, specimen);
	return studioWith(specimenOf(model, { query, texts }), model);
}

describe("the undo history of a tab", () => {
	let studio: Studio;
	let storage: MemoryStorage;
	const lengths = ({ state: { history } }: Studio) =>
		[...history.past, history.present, ...history.future].map(({ parameters }) => parameters.l);

	beforeEach(async () => {
		({ studio } = await studioWith(specimenFromPreset("riesling")));
		storage = new MemoryStorage();
		for (const l of [400, 410, 420, 430]) studio.set({ parameters: { l } });
		studio.undo();
		studio.undo();
	});

	it("is the same after a reload, and Undo and Redo work as before", async () => {
		const before = studio.state.history;
		storeHistory(studio, storage);
		const { studio: next, services } = await reloaded(studio);
		await restoreHistory(next, storage);
		expect(next.state.history).toEqual(before);
		// Nothing grows again for it.
		expect(services.grow).not.toHaveBeenCalled();
		next.undo();
		expect(next.state.specimen.parameters.l).toBe(400);
		next.redo();
		next.redo();
		next.redo();
		expect(next.state.specimen.parameters.l).toBe(430);
	});

	it("spans models, whose plants grow again on Undo", async () => {
		studio.choosePreset("plain", toyModel);
		studio.set({ parameters: { height: 7 } });
		storeHistory(studio, storage);
		const { studio: next, services } = await reloaded(studio);
		await restoreHistory(next, storage);
		next.undo();
		next.undo();
		expect(next.state.model).toBe(bunchModel);
		expect(next.state.specimen.parameters.l).toBe(410);
		expect(services.grow).toHaveBeenLastCalledWith(bunchModel, next.state.specimen, { preview: false });
		next.redo();
		next.redo();
		expect(next.state.model).toBe(toyModel);
		expect(next.state.specimen.parameters.height).toBe(7);
	});

	it("shares the long texts of steps, and restores them", async () => {
		const grammar = "axiom: F(1)\n".repeat(5000);
		for (let i = 0; i < 20; i++) studio.set({ details: { grammar: `${grammar}/* ${i} */\n` } });
		storeHistory(studio, storage);
		expect(storage.getItem("panicle.undo")?.length).toBeLessThan(2 * grammar.length);
		const { studio: next } = await reloaded(studio);
		await restoreHistory(next, storage);
		expect(next.state.history).toEqual(studio.state.history);
	});

	it("is not restored for another plant, but stays stored until that plant has steps", async () => {
		storeHistory(studio, storage);
		const { studio: other } = await studioWith(specimenFromPreset("lychee"));
		await restoreHistory(other, storage);
		expect(other.state.history.past).toEqual([]);
		storeHistory(other, storage);
		const { studio: back } = await reloaded(studio);
		await restoreHistory(back, storage);
		expect(lengths(back)).toEqual(lengths(studio));
		other.newVariation();
		storeHistory(other, storage);
		const { studio: late } = await reloaded(studio);
		await restoreHistory(late, storage);
		expect(late.state.history.past).toEqual([]);
	});

	it("comes before steps that were made while it was being restored", async () => {
		storeHistory(studio, storage);
		const { studio: next } = await reloaded(studio);
		const restoring = restoreHistory(next, storage);
		next.set({ parameters: { l: 500 } });
		await restoring;
		expect(lengths(next)).toEqual([...lengths(studio).slice(0, 3), 500]);
		expect(next.state.history.future).toEqual([]);
	});

	it("leaves a drag in progress as it is", async () => {
		storeHistory(studio, storage);
		const { studio: next } = await reloaded(studio);
		next.edit({ parameters: { l: 500 } });
		await restoreHistory(next, storage);
		expect(next.state.held).toBe(true);
		next.edit({ parameters: { l: 410 } });
		next.settle();
		// The drag ended where it began.
		expect(lengths(next)).toEqual(lengths(studio));
	});

	it("brings back the parts that the address could not hold", async () => {
		const model = await modelNamed("tree");
		const { studio: tree } = await studioWith(fromPreset(model), model);
		const shape = model.table.entry("shape");
		const mesh = shape?.kind === "choice" ? shape.options.indexOf("mesh") : -1;
		tree.set({ parameters: { shape: mesh }, details: { volume: BALL } });
		tree.newVariation();
		storeHistory(tree, storage);
		const { studio: next, services } = await reloaded(tree);
		expect(Reflect.get(next.state.specimen, "volume")).toBeUndefined();
		await restoreHistory(next, storage);
		expect(next.state.history).toEqual(tree.state.history);
		expect(services.grow).toHaveBeenCalledExactlyOnceWith(model, tree.state.specimen, { preview: false });
		next.undo();
		expect(Reflect.get(next.state.specimen, "volume")).toEqual(BALL);
	});

	it.each([
		"",
		"{",
		"7",
		'{"v":1}',
		'{"v":1,"pieces":[],"present":{"q":"?v=2&preset=riesling&l=410"},"past":[{"q":5}]}',
	])("ignores foreign data: %s", async (text) => {
		storage.setItem("panicle.undo", text);
		const { studio: next } = await reloaded(studio);
		await restoreHistory(next, storage);
		expect(next.state.history.past).toEqual([]);
		expect(next.state.specimen).toEqual(studio.state.specimen);
	});

	it("restores complete plants from any queries, up to one of an unknown model", async () => {
		const past = [{ q: "?l=1e9&p3=x&preset=none" }, { q: "?model=nowhere" }, { q: "?v=2" }];
		const present = { q: "?v=2&preset=riesling&l=410" };
		storage.setItem("panicle.undo", JSON.stringify({ v: 1, pieces: [], present, past, future: [] }));
		const { studio: next } = await reloaded(studio);
		await restoreHistory(next, storage);
		expect(next.state.history.past).toHaveLength(1);
		next.undo();
		expect(Object.keys(next.state.specimen.parameters)).toEqual(Object.keys(studio.state.specimen.parameters));
	});

	it("does without a storage that is full or forbidden", async () => {
		const refuse = () => {
			throw new DOMException("no", "SecurityError");
		};
		storeHistory(studio, { getItem: refuse, setItem: refuse, removeItem: refuse });
		await restoreHistory(studio, { getItem: refuse, setItem: refuse, removeItem: refuse });
		storage.setItem("panicle.undo", "an older history");
		storage.most = 10;
		storeHistory(studio, storage);
		expect(storage.getItem("panicle.undo")).toBeNull();
	});

	it("stores a shorter history where there is little room", async () => {
		const text = (i: number) => Array.from({ length: 4000 }, (_, at) => (at * 7 + i) % 99).join("F");
		for (let i = 0; i < 30; i++) studio.set({ details: { grammar: text(i) } });
		storage.most = 150_000;
		storeHistory(studio, storage);
		const { studio: next } = await reloaded(studio);
		await restoreHistory(next, storage);
		expect(next.state.history.past.length).toBeGreaterThan(3);
		expect(next.state.history.past).toEqual(studio.state.history.past.slice(-next.state.history.past.length));
	});

	it("does not store a plant of a model that is not loaded", async () => {
		vi.spyOn(studio, "modelOf").mockReturnValue(undefined);
		storeHistory(studio, storage);
		expect(storage.items.size).toBe(0);
	});
});

describe("a stored specimen", () => {
	it("is the same plant, for a preset of every kind of every model", async () => {
		for (const name of modelNames()) {
			const model = await modelNamed(name);
			for (const { key } of model.presets.kinds) {
				const preset = model.presets.list.find(({ kind }) => kind === key);
				if (!preset) continue;
				const specimen: Specimen = { ...fromPreset(model, preset.name), seed: 77 };
				expect(specimenOf(model, storedSpecimen(model, specimen)), `${name} ${preset.name}`).toEqual(specimen);
			}
		}
	});

	it("with damaged extra fields is the plant of its link", async () => {
		const model = await modelNamed("tree");
		const query = "?v=2&model=tree&shape=mesh";
		const plain = specimenOf(model, { query, texts: {} });
		for (const extra of ["{", "7", "null", '{"volume":7}', '{"volume":{"points":[0],"triangles":[9]}}', '{"none":1}'])
			expect(specimenOf(model, { query, texts: {}, extra }), extra).toEqual(plain);
	});

	it("ignores texts that are too long or of unknown keys", () => {
		const query = "?v=2&preset=riesling";
		const plain = specimenOf(bunchModel, { query, texts: {} });
		expect(specimenOf(bunchModel, { query, texts: { none: "F", g: "x".repeat(300_000) } })).toEqual(plain);
	});
});
