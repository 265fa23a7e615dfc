import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import { model } from "../../../../web/src/models/growth/index";
import { encodeGrowth } from "../../../../web/src/models/growth/request";
import { fromPreset } from "../../../../web/src/specimen/from_preset";

const OPEN = [0, 0, 0, 0, 0, 0, 0, 0, 99, 99, 99, 99, 99, 99, 99, 99];
const specimen = { ...fromPreset(model, "figure-5"), seed: 3 };

let core: Core;

beforeAll(async () => {
	core = await loadCoreFromBytes(readFileSync(new URL("../../../../build/core/growth.wasm", import.meta.url)));
	await model.prepare(specimen);
});

const grown = (options: Parameters<typeof encodeGrowth>[1], surroundings?: number[]) =>
	core.grow(encodeGrowth({ ...specimen, surroundings }, options)).columns;

describe("levels of a tree", () => {
	it("are four meshes of three runs each, and the only meshes if no others are requested", () => {
		const columns = grown({ levels: true, meshes: false, measures: false });
		expect(columns.lines("meshes")).toEqual(["level0", "level1", "level2", "level3"]);
		const tolerance = [...columns.floats("levels.tolerance")];
		expect(tolerance).toHaveLength(4);
		expect(tolerance).toEqual([...tolerance].sort((a, b) => a - b));
		for (const name of columns.lines("meshes")) {
			expect(columns.text(`mesh.${name}.material`)).toBe("level");
			expect(columns.lines(`mesh.${name}.runs.names`)).toEqual(["bark", "leaves", "blossoms"]);
			expect(columns.uint8(`mesh.${name}.sky`)).toHaveLength(columns.floats(`mesh.${name}.positions`).length / 3);
		}
	});

	it("have the requested number, each independent of the others", () => {
		const all = grown({ levels: true, meshes: false });
		for (const levelCount of [1, 3]) {
			const some = grown({ levels: true, levelCount, meshes: false });
			const names = some.lines("meshes");
			expect(names).toEqual(all.lines("meshes").slice(0, levelCount));
			expect(some.floats("levels.tolerance")).toEqual(all.floats("levels.tolerance").slice(0, levelCount));
			for (const name of names.map((each) => `mesh.${each}`)) {
				expect(some.floats(`${name}.positions`)).toEqual(all.floats(`${name}.positions`));
				expect(some.uint32(`${name}.indices`)).toEqual(all.uint32(`${name}.indices`));
				expect(some.uint8(`${name}.sky`)).toEqual(all.uint8(`${name}.sky`));
			}
		}
		for (const levelCount of [0, 5])
			expect(() => grown({ levels: true, levelCount })).toThrow("growth.levels_out_of_range");
	});

	it("change nothing else of the plant, and are absent if not requested", () => {
		const [without, beside] = [grown({}), grown({ levels: true })];
		expect(without.lines("meshes")).toEqual(["stems", "leaves"]);
		expect(beside.lines("meshes").slice(0, 2)).toEqual(["stems", "leaves"]);
		expect(beside.uint32("fingerprint")).toEqual(without.uint32("fingerprint"));
	});
});

describe("the surroundings of a tree", () => {
	it("changes how it grows, where there is something", () => {
		const alone = grown({ meshes: false }).uint32("fingerprint");
		const about = (numbers: number[]) => grown({ meshes: false }, numbers);
		expect(about(OPEN).uint32("fingerprint")).toEqual(alone);
		expect(about(OPEN.with(8, 0.5)).uint32("fingerprint")).not.toEqual(alone);
		expect(about(OPEN.with(2, 60)).uint32("fingerprint")).not.toEqual(alone);
	});

	it("is refused where it is not sixteen numbers", () => {
		for (const wrong of [OPEN.slice(1), OPEN.with(3, Number.NaN)])
			expect(() => grown({}, wrong)).toThrow("growth.surroundings_not_sixteen");
	});
});
