import { beforeEach, describe, expect, it } from "vitest";
import { applying, groupsFor } from "../../../../web/src/app/panel_groups";
import { model as flower } from "../../../../web/src/models/flower/index";
import { PRESETS } from "../../../../web/src/models/flower/presets.generated";
import { fetchTexts, usesAge } from "../../../../web/src/models/flower/texts";
import { age as flowerAge, LIFE } from "../../../../web/src/models/flower/ui/age";
import { model as growth } from "../../../../web/src/models/growth/index";
import { LIFE as OF_TREES } from "../../../../web/src/models/growth/ui/age";
import type { Model } from "../../../../web/src/models/model";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import type { NumberEntry } from "../../../../web/src/specimen/table";
import { stageOf } from "../../../../web/src/ui/life";
import { LifePlayer, type PlayState } from "../../../../web/src/ui/life_player";
import type { Tool } from "../../../../web/src/ui/tool";
import { studioWith } from "../../app/context";

const tulip = fromPreset(flower, "tulip");
const FRAME = 20;

describe("the life of a flower and of a tree", () => {
	it.each([
		["flower", flower.table.entry("age"), LIFE],
		["tree", growth.table.entry("age"), OF_TREES],
	] as const)("of a %s spans its age, and each stage is called what its button says", (_, entry, { stages, end }) => {
		const { min, max } = entry as NumberEntry;
		expect([stages[0].at, stages.at(-1)?.at, end]).toEqual([min, max, max]);
		for (const stage of stages) expect(stageOf({ stages } as typeof LIFE, stage.at)).toBe(stage);
	});

	it("is shown if the text depends on age, by its name or in colours; otherwise the panel has its slider", async () => {
		await fetchTexts();
		const deaf = PRESETS.filter(({ name }) => !usesAge(fromPreset(flower, name))).map(({ name }) => name);
		expect(deaf).toEqual(["figure-16", "petal", "table-3"]);
		const text = (line: string) => ({ ...tulip, grammar: `#define A(4,0,0,0,1,1,1,1)\n${line}\n#axiom: A\n` });
		expect(usesAge(text("/* age */ @ age @"))).toBe(false);
		expect(usesAge(text('#material 1 petal "ff0000" wilted "800000"'))).toBe(true);
		expect(usesAge(text('#material 1 petal "ff0000" name "bud"'))).toBe(false);
		const shown = (specimen: typeof tulip) => {
			const groups = groupsFor(flower.table, specimen, applying([flowerAge as unknown as Tool], specimen));
			return groups.flatMap(({ entries }) => entries.map(({ key }) => key));
		};
		expect(shown(tulip)).not.toContain("age");
		expect(shown(fromPreset(flower, "table-3"))).toContain("age");
	});
});

describe("a flower that lives", () => {
	const PLAYED = { name: "played", initial: { playing: false } as PlayState };
	let age: () => number;
	let play: () => number[];
	let studio: Awaited<ReturnType<typeof studioWith>>["studio"];

	beforeEach(async () => {
		({ studio } = await studioWith(tulip, flower as unknown as Model));
		let due: ((now: number) => void) | undefined;
		age = () => studio.state.specimen.parameters.age;
		new LifePlayer(studio, LIFE, PLAYED, {
			request: (callback) => {
				due = callback;
			},
			stepwise: () => false,
		});
		play = () => {
			studio.setToolState(PLAYED, { playing: true });
			const seen: number[] = [];
			for (let now = 0; due && now < 30_000; now += FRAME) {
				const callback = due;
				due = undefined;
				callback(now);
				seen.push(age());
			}
			return seen;
		};
	});

	it("is played from the start if it is open, in steps that its link can hold, and otherwise from its age on", () => {
		const seen = play();
		expect(seen[0]).toBe(0);
		expect(age()).toBe(2);
		expect(seen).toEqual([...seen].sort((a, b) => a - b));
		expect(new Set(seen).size).toBeGreaterThan(180);
		for (const each of seen) expect(String(each)).toMatch(/^\d(?:\.\d\d?)?$/);
		studio.set({ parameters: { age: 1.4 } });
		expect(play()[0]).toBe(1.4);
	});
});
