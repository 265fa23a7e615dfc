import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { chosenOf, stillChosen } from "../../../../web/src/models/flower/ui/chosen_volume";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	core = await freshCore("flower.wasm");
});

/** A stem of three rings, each with petals, the last with a bud. */
const TEXT = `#define STEM(8)
#define PETAL(4)
#define BUD(4)
#axiom: STEM
#define finalStep=3
STEM{}{step<2}{} -> STEM[STEM]_{E}
STEM{}{step==2}{} -> STEM[BUD]_{E}
STEM -> STEM[PETAL]_{C1, C4}
`;
const grown = (grammar: string): FlowerPlant =>
	readFlowerPlant(core.grow(model.encode({ ...fromPreset(model), grammar }, { meshes: false, map: false })));

describe("the chosen volume", () => {
	it("is every volume's own", () => {
		const plant = grown(TEXT);
		const count = plant.volumes.order.length;
		expect(count).toBe(10);
		for (let volume = 0; volume < count; volume++) expect(stillChosen(plant, chosenOf(plant, volume))).toBe(volume);
	});

	it("stays the same one where others come before it, lines move and sides change", () => {
		const before = grown(TEXT);
		const { labels, label, parent } = before.volumes;
		const name = (plant: FlowerPlant, of: number) => plant.volumes.labels[plant.volumes.label[of]];
		const bud = label.findIndex((of) => labels[of] === "BUD");
		const chosen = chosenOf(before, bud);
		const richer = grown(
			`/* more */\n${TEXT.replace("#define PETAL(4)", "#define PETAL(6,0,0,0,3,2,2,1)\n#define HAIR(3)")}PETAL -> PETAL[HAIR]_{E}\n`,
		);
		const now = stillChosen(richer, chosen) ?? -1;
		expect(now).not.toBe(bud);
		expect(name(richer, now)).toBe("BUD");
		// Of two equal ones, the same as before.
		const petals = [...label.keys()].filter((of) => labels[label[of]] === "PETAL" && parent[of] === parent[bud]);
		expect(petals).toHaveLength(2);
		const again = petals.map((petal) => stillChosen(richer, chosenOf(before, petal)) ?? -1);
		expect(again.map((petal) => name(richer, petal))).toEqual(["PETAL", "PETAL"]);
		expect(again.map((petal) => richer.volumes.parent[petal])).toEqual(again.map(() => richer.volumes.parent[now]));
		expect(again[0]).toBeLessThan(again[1]);
	});

	it("is none where it is gone, and no other in its place", () => {
		const before = grown(TEXT);
		const { labels, label } = before.volumes;
		const last = label.findLastIndex((of) => labels[of] === "PETAL");
		const chosen = chosenOf(before, last);
		expect(stillChosen(grown(TEXT.replace("C1, C4", "C1")), chosen)).toBeUndefined();
		expect(stillChosen(grown(TEXT.replaceAll("PETAL", "SEPAL")), chosen)).toBeUndefined();
		expect(stillChosen(grown(TEXT.replace("finalStep=3", "finalStep=1")), chosen)).toBeUndefined();
		expect(stillChosen(undefined, chosen)).toBeUndefined();
		expect(stillChosen(before, undefined)).toBeUndefined();
	});

	it.each([
		["a rest that stands before what it was split from", "A -O-> B C\n"],
		["parts of what bears", "A{}{step==0}{} -> A[D]_{E}\nA -E-> B C\n"],
	])("is every volume's own where the text splits: %s", (_, productions) => {
		const plant = grown(
			`#define A(4)\n#define B(4)\n#define C(4)\n#define D(4)\n#axiom: A\n#define finalStep=2\n${productions}`,
		);
		const { order, parent } = plant.volumes;
		// Otherwise nothing is shown.
		expect(parent.some((from, at) => from !== 0xffffffff && from > at)).toBe(true);
		for (let volume = 0; volume < order.length; volume++)
			expect(stillChosen(plant, chosenOf(plant, volume))).toBe(volume);
	});

	it("is none of volumes that grew from each other", () => {
		const { volumes } = grown(TEXT);
		const round = { volumes: { ...volumes, parent: volumes.parent.map((_, at) => (at + 1) % 10) } };
		expect(chosenOf(round, 3)).toBeUndefined();
		expect(stillChosen(round, [{ label: "STEM", nth: 0 }])).toBeUndefined();
	});

	it("is none where there is none of that number", () => {
		const plant = grown(TEXT);
		for (const volume of [plant.volumes.order.length, -1, undefined]) expect(chosenOf(plant, volume)).toBeUndefined();
		expect(chosenOf(undefined, 0)).toBeUndefined();
	});
});
