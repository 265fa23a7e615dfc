/** Traces of a bunch's derivation, with the responses of its environment. */
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreMessages } from "../../../../web/src/core/core_message";
import { readableTrace } from "../../../../web/src/generate/readable";
import type { BunchPlant } from "../../../../web/src/models/bunch/bunch_plant";
import {
	type DerivationTrace,
	MAX_TRACE_ENTRIES,
	NOT_DRAWN,
	type TraceEntry,
} from "../../../../web/src/plant/derivation_trace";
import { type Specimen, specimenFromPreset, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	core = await freshCore();
	await loadCoreMessages();
});

const LAST = 0xffffffff;
const bare = { meshes: false, measures: false };

function growTraced(specimen: Specimen, first = 0): BunchPlant & { trace: DerivationTrace } {
	const grown = growBunch(core, specimen, { ...bare, trace: { step: LAST, first } });
	if (!grown.trace) throw new Error("Nothing was told.");
	return { ...grown, trace: readableTrace(grown.trace) };
}

/** Returns all modules of the last string. */
function lastString(specimen: Specimen): TraceEntry[] {
	const modules: TraceEntry[] = [];
	for (;;) {
		const more = growTraced(specimen, modules.length).trace.modules;
		modules.push(...more);
		if (more.length < MAX_TRACE_ENTRIES) return modules;
	}
}

const words = ({ answer }: TraceEntry) => answer?.words ?? "";
const withWords = (modules: TraceEntry[], pattern: RegExp) => modules.filter((each) => pattern.test(words(each)));

describe("the trace of the paper's bunch", () => {
	const crowded = () => withParameters(specimenFromPreset("cylindrical", 1), { rmin: 30, rmax: 40 });

	it("shows for each pedicel whether its berry found room, and for each internode whether it was cut", () => {
		const specimen = crowded();
		const { counts } = growBunch(core, specimen, bare);
		const modules = lastString(specimen);
		const queries = modules.filter(({ text }) => text.startsWith("?E"));
		expect(counts.withered).toBeGreaterThan(5);
		expect(withWords(queries, /the pedicel withers/)).toHaveLength(counts.withered);
		expect(withWords(queries, /the internode is cut/)).toHaveLength(counts.cut);
		// Modules of a cut are never queried.
		expect(withWords(queries, /^There is room/)).toHaveLength(counts.internodes - counts.withered);
	});

	it("shows the production that drew each query, with its response", () => {
		const modules = lastString(crowded());
		const withered = withWords(modules, /the pedicel withers/);
		const set = withWords(modules, /^There is room/).filter(({ text }) => text.startsWith("?E(1"));
		expect(new Set(withered.map(({ fires }) => fires?.line)).size).toBe(1);
		expect(new Set(set.map(({ fires }) => fires?.line)).size).toBe(1);
		expect(withered[0].fires).not.toEqual(set[0].fires);
		for (const { answer, values } of [...withered, ...set]) {
			expect(values.map(({ name }) => name)).toEqual(["type", "theta", "phi", "l", "w", "b"]);
			expect(values.map(({ value }) => value)).toEqual(answer?.answered);
		}
		for (const { answer } of withered) expect(answer?.answered[3]).toBe("10");
	});

	it("names the existing obstacle", () => {
		const specimen = crowded();
		const { berries, trace } = growTraced(specimen);
		const modules = lastString(specimen);
		const drawnBy = new Set(trace.organs);
		expect(drawnBy.size).toBe(berries.count);
		const named = withWords(modules, /overlaps? the berry of module #\d+ by \d/);
		expect(named.length).toBeGreaterThan(10);
		for (const module of named) {
			const [, berry, depth] = /berry of module #(\d+) by (\d+(?:\.\d+)?)/.exec(words(module)) ?? [];
			expect(drawnBy).toContain(Number(berry));
			expect(Number(depth)).toBeGreaterThan(0);
			expect(Number(depth)).toBeLessThan(80);
		}
		for (const other of withWords(modules, /internode of module/)) {
			const [, index] = /internode of module #(\d+)/.exec(words(other)) ?? [];
			expect(modules[Number(index)].text).toMatch(/^\?E\(0/);
		}
	});

	it("shows how far internodes with room were turned, and from which direction", () => {
		const turned = withWords(lastString(specimenFromPreset("long-conical", 1)), /^There is room for this part after/);
		expect(turned.length).toBeGreaterThan(2);
		for (const module of turned)
			expect(words(module)).toMatch(
				/after turning by [\d.]+° in \d+ turns?\. Without turning, this part would (overlap|touch) the (berry|internode) of/,
			);
	});

	it("omits a second bunch, and the names of obstacles in it", () => {
		const specimen = withParameters(crowded(), { wing: 0.7 });
		const { internodes, trace, counts } = growTraced(specimen);
		const drawn = trace.segments.filter((module) => module !== NOT_DRAWN);
		expect(trace.segments).toHaveLength(internodes.count);
		expect(drawn.length).toBeLessThan(internodes.count);
		expect(drawn.length).toBeGreaterThan(counts.internodes / 3);
		expect(withWords(lastString(specimen), /of the second bunch/).length).toBeGreaterThan(0);
	});
});

describe("the trace of the natural bunch", () => {
	it("leaves the bunch unchanged, and shows the outcome of each flower", () => {
		const specimen = specimenFromPreset("long-conical");
		const plain = growBunch(core, specimen, bare);
		const modules = lastString(specimen);
		expect(plain.trace).toBeUndefined();
		expect(growTraced(specimen).fingerprint).toBe(plain.fingerprint);
		const why = (reason: string) => plain.thinned.filter((each) => each.why === reason).length;
		expect(withWords(modules, /did not set/)).toHaveLength(why("not set"));
		expect(withWords(modules, /pressed too hard/)).toHaveLength(why("no room"));
		expect(withWords(modules, /inside the outline/)).toHaveLength(why("outside"));
		expect(withWords(modules, /becomes the berry|does not set/)).toHaveLength(plain.berries.count);
		const [taken] = plain.berries.ids ?? [];
		const thinned = { ...specimen, thinned: [taken] };
		expect(withWords(lastString(thinned), /by hand/)).toHaveLength(1);
	});

	it("names the modules that drew berries and internodes", () => {
		for (const name of ["long-conical", "riesling"]) {
			const specimen = specimenFromPreset(name);
			const { trace, internodes, berries } = growTraced(specimen);
			const modules = lastString(specimen);
			expect(trace.segments).toHaveLength(internodes.count);
			expect(trace.organs).toHaveLength(berries.count);
			for (const module of trace.segments) if (module !== NOT_DRAWN) expect(modules[module].text).toMatch(/^\?E\(/);
			for (const module of trace.organs) if (module !== NOT_DRAWN) expect(modules[module].text).toMatch(/^\?E\(1/);
			expect(trace.segments.filter((module) => module !== NOT_DRAWN).length).toBeGreaterThan(internodes.count / 2);
		}
	});

	it("grows up to a given step only", () => {
		const specimen = specimenFromPreset("long-conical");
		const three = growBunch(core, specimen, { ...bare, steps: 3, trace: { step: LAST } });
		expect(three.trace?.step).toBe(3);
		expect([...(three.trace?.counts ?? [])]).toEqual([...growTraced(specimen).trace.counts.slice(0, 4)]);
	});
});
