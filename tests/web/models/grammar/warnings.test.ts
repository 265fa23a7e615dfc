import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { readablePlant } from "../../../../web/src/generate/readable";
import type { GrammarPlant } from "../../../../web/src/models/grammar/grammar_plant";
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

const grow = (specimen: GrammarSpecimen): Promise<GrammarPlant> =>
	readablePlant(model.read(core.grow(model.encode(specimen, { meshes: false })), specimen));
const warningsFor = async (specimen: GrammarSpecimen) => warningsOf(await grow(specimen), specimen);
const note = (code: string, text: string, args = {}) => ({ code: `core.grammar.${code}`, args, text });
const cubes = (): GrammarSpecimen => {
	const preset = fromPreset(model, "topiary-two-cubes");
	return { ...preset, constants: { ...preset.constants, leaf: 0.2 } };
};
const of = (grammar: string): GrammarSpecimen => ({ ...fromPreset(model), grammar, constants: {} });

describe("warnings about a plant", () => {
	it("are none for the presets", async () => {
		const presets = model.presets.list.filter(({ kind }, i) => kind === "topiary" || i % inRun(8, 1) === 0);
		for (const { name } of presets) expect(await warningsFor(fromPreset(model, name)), name).toEqual([]);
		expect(await warningsFor(cubes())).toEqual([]);
	});

	it("is each area that the main branch does not reach", async () => {
		const missed = { ...cubes(), path: [0, 0, 0, 5, 0.1, 0, 5, 0.2, 0] };
		expect([...bareAreas(await grow(missed))]).toEqual([1]);
		expect(await warningsFor(missed)).toEqual([
			"Area 2 stays empty, because the main branch does not reach it. Lead the branch through it, change the order of the areas, or, if it is far away, increase the derivation length.",
		]);
		expect([...bareAreas(await grow(cubes()))]).toEqual([]);
		const notes = [1, 2, 4].map((area) => note("area_not_reached", `Area ${area} stays empty.`, { area }));
		const { counts } = await grow(cubes());
		expect(warningsOf({ noteMessages: notes, counts }, cubes())).toEqual([
			expect.stringMatching(/^Areas 1, 2 and 4 stay empty, because the main branch does not reach them\./),
		]);
		// Notes of another reason stay separate.
		const others = [...notes, note("area_in_area", "Area 3 stays empty.", { area: 3, other: 2 })];
		expect(warningsOf({ noteMessages: others, counts }, cubes())).toHaveLength(2);
		expect([...bareAreas({ noteMessages: others })]).toEqual([0, 1, 3, 2]);
	});

	it("is every area, where the last is gone", async () => {
		const { areas: _, ...none } = cubes();
		expect(await warningsFor(none)).toEqual([expect.stringContaining("There is no growth area")]);
	});

	it("report a derivation that a limit stopped, with the requested steps", () => {
		const text = "derivation length: 60\naxiom: F\nF --> F [ +F ] F";
		const words =
			"The plant is shown as far as it has grown. The string exceeds the limit of 67,108,864 words of memory.";
		const cut = { noteMessages: [note("cut_short", words)], counts: { steps: 12 } };
		expect(warningsOf(cut, of(text))).toEqual([`${words} Stopped after step 12 of 60.`]);
		for (const length of ["Derivation length: 60 /* many */", "#define ν 60 /* 1 … 90 */\nderivation  length : ν"])
			expect(warningsOf(cut, of(`${length}\naxiom: F`))).toEqual([
				expect.stringMatching(/Stopped after step 12 of 60\.$/),
			]);
		const fewer = { ...of("#define n 60\nderivation length: n\naxiom: F"), constants: { n: 20 } };
		expect(warningsOf(cut, fewer)).toEqual([expect.stringMatching(/Stopped after step 12 of 20\.$/)]);
		// Names that every object has are no constants.
		for (const name of ["constructor", "toString", "__proto__"])
			expect(warningsOf(cut, of(`#define ${name} 60\nderivation length: ${name}\naxiom: F`))).toEqual([
				expect.stringMatching(/Stopped after step 12 of 60\.$/),
			]);
		expect(warningsOf(cut, of("derivation length: 2*n\naxiom: F"))).toEqual([
			expect.stringMatching(/words of memory\.$/),
		]);
	});

	it("report a text that draws nothing", async () => {
		expect(await warningsFor(of("axiom: A"))).toEqual([
			"The grammar does not draw anything; add a symbol that draws, such as “F” for a line.",
		]);
	});

	it("is the value of a constant that the text has not", async () => {
		const specimen = { ...of("#define n 3\naxiom: F(n)"), constants: { n: 2, foo: 1 } };
		expect(await warningsFor(specimen)).toEqual(["The grammar has no “#define foo”, so this parameter has no effect."]);
	});
});
