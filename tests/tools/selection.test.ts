import { describe, expect, it } from "vitest";
import { rooms, select } from "../selection.mjs";

const STAGES = ["set-up", "types", "native core", "web", "e2e"];

describe("the tests that `npm test` runs", () => {
	it("are all without a word", () => {
		expect(select([], STAGES)).toEqual({ stages: STAGES, native: undefined, web: [] });
	});

	it("are one model's, in the core, in the web and among the goldens", () => {
		expect(select(["bunch"], STAGES)).toEqual({
			stages: ["native core", "web"],
			native: ["bunch_tests"],
			web: ["tests/web/models/bunch/", "tests/golden/bunch."],
		});
	});

	it("are one room's, on whichever side it stands", () => {
		expect(select(["lsystem"], STAGES)).toEqual({ stages: ["native core"], native: ["lsystem_tests"], web: [] });
		expect(select(["studio"], STAGES)).toEqual({ stages: ["web"], native: undefined, web: ["tests/web/studio/"] });
		expect(select(["core"], STAGES)).toEqual({
			stages: ["native core", "web"],
			native: ["core_tests"],
			web: ["tests/web/core/"],
		});
	});

	it("are all models', or those of a folder beside the rooms", () => {
		expect(select(["models"], STAGES)).toEqual({
			stages: ["native core", "web"],
			native: ["bunch_tests", "flower_tests", "grammar_tests", "growth_tests", "particles_tests", "stand_tests"],
			web: ["tests/web/models/", "tests/golden/"],
		});
		for (const folder of ["fuzz", "golden", "tools", "toy"]) {
			expect(select([folder], STAGES)).toEqual({ stages: ["web"], native: undefined, web: [`tests/${folder}/`] });
		}
	});

	it("are a stage's whole where the stage is named as well", () => {
		expect(select(["types", "web", "studio", "lsystem"], STAGES)).toEqual({
			stages: ["types", "web", "native core"],
			native: ["lsystem_tests"],
			web: [],
		});
	});

	it("are those that build the app, where it is looked at", () => {
		for (const stage of ["e2e", "browsers"]) {
			const { stages } = select([stage], [...STAGES, "wasm core", "app", "browsers"]) as { stages: string[] };
			expect(stages).toEqual(["wasm core", "app", stage]);
		}
	});

	it("are none for a word that means nothing", () => {
		expect(select(["bunch", "grapes"], STAGES)).toEqual({ unknown: ["grapes"] });
		expect(rooms()).toEqual(expect.arrayContaining(["bunch", "core", "lsystem", "scene", "specimen"]));
	});
});
