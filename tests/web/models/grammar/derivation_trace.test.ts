/** Traces of a text's derivation. */
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreMessages } from "../../../../web/src/core/core_message";
import { exportJson, writeJson } from "../../../../web/src/formats/json";
import { readableTrace } from "../../../../web/src/generate/readable";
import type { GrammarPlant } from "../../../../web/src/models/grammar/grammar_plant";
import { model } from "../../../../web/src/models/grammar/index";
import type { GrammarSpecimen } from "../../../../web/src/models/grammar/specimen";
import { fetchTexts } from "../../../../web/src/models/grammar/texts";
import type { TraceRequest } from "../../../../web/src/plant/derivation_trace";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	await loadCoreMessages();
	core = await freshCore("grammar.wasm");
});

const of = (grammar: string): GrammarSpecimen => ({ ...fromPreset(model), grammar });
const grow = (specimen: GrammarSpecimen, trace: TraceRequest, steps?: number): GrammarPlant =>
	model.read(
		core.grow(
			model.encode(specimen, { meshes: false, string: true, trace, ...(steps === undefined ? {} : { steps }) }),
		),
	);
const traceOf = (grammar: string, request: TraceRequest) => {
	const { trace } = grow(of(grammar), request);
	if (!trace) throw new Error("Nothing was told.");
	return readableTrace(trace);
};

const TWIGS = "axiom: A(1)\nA(n) : {m = n/2} n<3 --> F(m) [ +(40) A(n+1) ] A(n+1)\n";

describe("the trace of a text's plant", () => {
	it("lists module by module", () => {
		const trace = traceOf(TWIGS, { step: 1, module: 9 });
		expect([...trace.counts]).toEqual([1, 6, 16]);
		expect(trace.modules.map(({ text }) => text)).toEqual(["F(0.5)", "[", "+(40)", "A(2)", "]", "A(2)"]);
		expect(trace.modules[3]).toEqual({
			text: "A(2)",
			parent: 0,
			production: { line: 2, column: 1 },
			fires: { line: 2, column: 1 },
			values: [
				{ name: "n", value: "2" },
				{ name: "m", value: "1" },
			],
			children: { first: 3, count: 6 },
			last: { first: 3, count: 6 },
		});
		expect(trace.modules[0]).toEqual({
			text: "F(0.5)",
			parent: 0,
			production: { line: 2, column: 1 },
			values: [],
			children: { first: 0, count: 1 },
			last: { first: 0, count: 1 },
		});
		expect([...(trace.trail ?? [])]).toEqual([0, 4, 9]);
	});

	it("has for each module the productions that do not rewrite it, and why", () => {
		const [bud, twig] = traceOf("axiom: A(3) B\nA(n) : n>3 --> F\nA --> F\nA(n) --> F", { step: 0 }).modules;
		expect(bud.refusals).toEqual([
			{ production: { line: 2, column: 1 }, why: "the condition is false with n = 3" },
			{
				production: { line: 3, column: 1 },
				why: "the production expects no parameters, but the module has 1 parameter",
			},
		]);
		expect(bud.fires).toEqual({ line: 4, column: 1 });
		expect(twig).not.toHaveProperty("refusals");
	});

	it("names the modules that drew the lines", () => {
		const trace = traceOf(TWIGS, { step: 1, module: 9 });
		expect([...trace.segments]).toEqual([0, 3, 10]);
		const [axiom] = traceOf(TWIGS, { step: 0 }).modules;
		expect(axiom.parent).toBeUndefined();
		expect(axiom.production).toBeUndefined();
	});

	it("shows the probabilities of stochastic productions, and nothing for missing modules", () => {
		const trace = traceOf("axiom: A\nA --> B : 3\nA --> C : 1\n", { step: 0, module: 1 });
		const { total, weight, drawn } = trace.modules[0].chance ?? { total: 0, weight: 0, drawn: 0 };
		expect(total).toBe(4);
		expect(weight).toBe(drawn < 3 ? 3 : 1);
		expect(trace.trail).toBeUndefined();
		expect(traceOf(TWIGS, { step: 1, first: 6 }).modules).toEqual([]);
	});

	it("shows queries to the environment and its responses", () => {
		const hedge = [
			"derivation length: 4",
			"axiom: F A ?E(0.9, 0)",
			"A > ?E(r,n) : n<3 --> F [ +(55) A ?E(0.9,0) ] A",
			"A > ?E(r,n) : n>=3 --> ~leaf(0.6)",
		].join("\n");
		const trace = traceOf(hedge, { step: 3 });
		const answered = trace.modules.filter(({ answer }) => answer);
		expect(answered.length).toBeGreaterThan(1);
		for (const { text, answer } of answered) {
			expect(text).toBe(`?E(${answer?.asked?.join()})`);
			expect(answer?.answered[0]).toBe("0.9");
		}
		// The responses determine which productions fire before them.
		for (const [index, { fires }] of trace.modules.entries()) {
			const next = trace.modules[index + 1]?.answer;
			if (fires && next) expect(fires.line).toBe(Number(next.answered[1]) < 3 ? 3 : 4);
		}
		const [, query] = traceOf("derivation length: 1\naxiom: F ?P(0,0,0)", { step: 0 }).modules;
		expect(query.answer).toEqual({ answered: ["0", "1", "0"] });
	});

	it("ends in the string of every preset, one module after the other, and changes nothing of the plant", () => {
		for (const { name } of model.presets.list.filter((_, index) => index % 6 === 0)) {
			const specimen = fromPreset(model, name);
			const grown = grow(specimen, { step: 4096, count: 300 });
			const plain = model.read(core.grow(model.encode(specimen, { meshes: false })));
			expect(plain.trace).toBeUndefined();
			expect(grown.fingerprint).toBe(plain.fingerprint);
			expect(grown.notes).toEqual(plain.notes);
			expect(grown.trace?.counts.at(-1)).toBe(grown.counts.modules);
			const start = (grown.trace?.modules ?? []).map(({ text }) => text).join("");
			expect(grown.string?.replaceAll(" ", "").startsWith(start.replaceAll(" ", ""))).toBe(true);
		}
	});

	it("grows up to a given step only, and rejects windows that are too long", () => {
		const one = grow(of(TWIGS), { step: 1 }, 1);
		expect(one.string).toBe("F(0.5)[+(40)A(2)]A(2)");
		expect(one.trace?.step).toBe(1);
		expect(() => grow(of(TWIGS), { step: 0, count: 2001 })).toThrow("lsystem_plant.trace_window_too_long");
	});

	it("is in the JSON document", () => {
		const specimen = of(TWIGS);
		const grown = grow(specimen, { step: 2, count: 1 });
		const json = exportJson(model, grown, specimen);
		expect(json.chronicle).toEqual({
			counts: [1, 6, 16],
			step: 2,
			first: 0,
			modules: [
				{ text: "F(0.5)", parent: 0, values: [], children: { first: 0, count: 0 }, last: { first: 0, count: 1 } },
			],
		});
		expect(JSON.parse(writeJson(model, grown, specimen).toString())).toEqual(JSON.parse(JSON.stringify(json)));
	});
});
