import { beforeAll, describe, expect, it } from "vitest";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { organOf, placeOfVolume, titleOfVolume } from "../../../../web/src/models/flower/ui/organ";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";

/** A stem of two segments, each with two organs of one call and one of another, which have hairs. */
const TEXT = `#define STEM(8,0,0,0,9,3,3,1)
#axiom: STEM
#material 1 stem "7f9a55"
#material 4 petal "c8102e" name "upper epidermis"
#material 5 petal "c8102e" name "tepal, mesophyll"
#material 6 seed "c8102e"
#define finalStep=9
STEM{}{step<2}{} -> STEM[STEM]_{E}
STEM{}{step==1}{} -> STEM[&BLADE]_{C1,C4}
STEM{}{step==1}{} -> STEM[&BLADE]_{C6}
/*
#module NOT
*/
#module OTHER
#define O(4,0,0,0,1,1,1,1)
#axiom: O
#module BLADE
#define finalStep=3
#define X1(4,0,0,0,2,2,2,4)
#define X2(4,0,0,0,1,1,1,5)
#axiom: X1
X1{}{step<3}{} -> X1[X1]_{E}
X1{}{step==2}{} -> X1[X2]_{C1}
`;

describe("the organ of a volume", () => {
	let plant: FlowerPlant;
	let of: (label: string) => number[];
	beforeAll(async () => {
		const core = await freshCore("flower.wasm");
		plant = readFlowerPlant(core.grow(model.encode({ ...fromPreset(model), grammar: TEXT })));
		const { labels, label } = plant.volumes;
		of = (name) => [...label.keys()].filter((volume) => labels[label[volume]] === name);
	});

	it("is one call of its module, another for each face, and the same for each of its volumes", () => {
		const organs = of("X1").map((volume) => organOf(plant.volumes, volume));
		const names = new Set(organs.map(({ volumes }) => [...volumes].join()));
		expect(names.size).toBe(6);
		const blades = of("X1").length + of("X2").length;
		const sizes = [...names].map((name) => name.split(",").length);
		expect(sizes.reduce((sum, size) => sum + size, 0)).toBe(blades);
		expect([...organOf(plant.volumes, 0).volumes]).toEqual(of("STEM"));
		// The hair belongs to the organ, one segment behind its parent.
		const [hair] = of("X2");
		const parent = plant.volumes.parent[hair];
		const [own, its] = [hair, parent].map((volume) => organOf(plant.volumes, volume));
		expect(own.volumes).toEqual(its.volumes);
		expect(own.segment).toBe(its.segment + 1);
	});

	it("is named by its material and by its module, ignoring comments", () => {
		const [blade, hair] = [of("X1")[0], of("X2")[0]];
		expect(titleOfVolume(plant, blade)).toBe("Petal, upper epidermis");
		expect(titleOfVolume(plant, hair)).toBe("Tepal, mesophyll");
		expect(titleOfVolume(plant, 0)).toBe("Stem");
		expect(titleOfVolume({ ...plant, numbers: new Uint32Array() }, hair)).toBe("X2");
		const placeOf = (volume: number) => placeOfVolume(plant.volumes, volume, organOf(plant.volumes, volume), TEXT);
		expect(placeOf(0)).toBe(`STEM, volume 1: segment 1 among ${of("STEM").length} volumes.`);
		const many = organOf(plant.volumes, blade).volumes.size;
		expect(placeOf(blade)).toBe(`X1, volume ${blade + 1}: segment 1 of BLADE, which has ${many} volumes.`);
	});
});
