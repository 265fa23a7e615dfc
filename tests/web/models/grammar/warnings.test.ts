import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { model } from "../../../../web/src/models/grammar/index";
import type { GrammarSpecimen } from "../../../../web/src/models/grammar/specimen";
import { fetchTexts } from "../../../../web/src/models/grammar/texts";
import { bareAreas, warningsOf } from "../../../../web/src/models/grammar/ui/warnings";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { inRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("grammar.wasm");
});

const grow = (specimen: GrammarSpecimen) => model.read(core.grow(model.encode(specimen, { meshes: false })), specimen);
const warningsFor = (specimen: GrammarSpecimen) => warningsOf(grow(specimen), specimen);
const cubes = (): GrammarSpecimen => {
	const preset = fromPreset(model, "topiary-two-cubes");
	return { ...preset, constants: { ...preset.constants, leaf: 0.2 } };
};
const of = (grammar: string): GrammarSpecimen => ({ ...fromPreset(model), grammar, constants: {} });

describe("warnings about a plant", () => {
	it("are none for the presets", () => {
		const presets = model.presets.list.filter(({ kind }, i) => kind === "topiary" || i % inRun(8, 1) === 0);
		const wrong = presets.flatMap(({ name }) =>
			warningsFor(fromPreset(model, name)).map((words) => `${name}: ${words}`),
		);
		expect(wrong).toEqual([]);
		expect(warningsFor(cubes())).toEqual([]);
	});

	it("is each area that the main branch does not come to", () => {
		const missed = { ...cubes(), path: [0, 0, 0, 5, 0.1, 0, 5, 0.2, 0] };
		expect([...bareAreas(grow(missed))]).toEqual([1]);
		expect(warningsFor(missed)).toEqual([
			"Nothing grows in area 2: the main branch does not come there. Lead it through, or change the areas' order; where it is far away, give it more steps (derivation length).",
		]);
		expect([...bareAreas(grow(cubes()))]).toEqual([]);
		const notes = [1, 2, 4].map((area) => `Nothing grows in area ${area}: it is missed.`);
		expect(warningsOf({ ...grow(cubes()), notes }, cubes())).toEqual([
			"Nothing grows in areas 1, 2 and 4: it is missed.",
		]);
		// Notes of another reason stay separate.
		const others = [...notes, "Nothing grows in area 3: it lies within area 2."];
		expect(warningsOf({ ...grow(cubes()), notes: others }, cubes())).toHaveLength(2);
	});

	it("is every area, where the last is gone", () => {
		const { areas: _, ...none } = cubes();
		expect(warningsFor(none)).toEqual([expect.stringContaining("There is no growth area")]);
	});

	it("report a derivation that a limit stopped, with the requested steps", () => {
		const text = "derivation length: 60\naxiom: F\nF --> F [ +F ] F";
		const words = "What grew so far is shown. ";
		const plant = grow(of("axiom: F"));
		const cut = {
			...plant,
			notes: [`${words}The string grows beyond 67108864 words.`],
			counts: { ...plant.counts, steps: 12 },
		};
		expect(warningsOf(cut, of(text))).toEqual([
			"What grew so far is shown. The string grows beyond 67,108,864 words. These are 12 of 60 steps.",
		]);
		for (const length of ["Derivation length: 60 /* many */", "#define ν 60 /* 1 … 90 */\nderivation  length : ν"])
			expect(warningsOf(cut, of(`${length}\naxiom: F`))).toEqual([
				expect.stringMatching(/These are 12 of 60 steps\.$/),
			]);
		const fewer = { ...of("#define n 60\nderivation length: n\naxiom: F"), constants: { n: 20 } };
		expect(warningsOf(cut, fewer)).toEqual([expect.stringMatching(/These are 12 of 20 steps\.$/)]);
		// Names that every object has are no constants.
		for (const name of ["constructor", "toString", "__proto__"])
			expect(warningsOf(cut, of(`#define ${name} 60\nderivation length: ${name}\naxiom: F`))).toEqual([
				expect.stringMatching(/These are 12 of 60 steps\.$/),
			]);
		expect(warningsOf(cut, of("derivation length: 2*n\naxiom: F"))).toEqual([expect.stringMatching(/words\.$/)]);
		expect(readFileSync("wasm-core/src/models/grammar/model.cpp", "utf8")).toContain(`"${words}"`);
	});

	it("report a text that draws nothing", () => {
		expect(warningsFor(of("axiom: A"))).toEqual(["The grammar draws nothing."]);
	});

	it("is the value of a constant that the text has not", () => {
		const specimen = { ...of("#define n 3\naxiom: F(n)"), constants: { n: 2, foo: 1 } };
		expect(warningsFor(specimen)).toEqual(["The grammar has no #define foo, so its parameter changes nothing."]);
	});
});
