import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { Columns, writeContainer } from "../../../../web/src/core/container";
import { CoreError } from "../../../../web/src/core/errors";
import { NUMBER_KEYS, type NumberKey } from "../../../../web/src/models/bunch/parameters.generated";
import { encodeRequest } from "../../../../web/src/models/bunch/request";
import { type Specimen, specimenFromPreset, withParameters } from "../../bunch";

const columns = (specimen: Specimen, options?: Parameters<typeof encodeRequest>[1]) =>
	new Columns(writeContainer(encodeRequest(specimen, options)));
const parameter = (specimen: Specimen, key: NumberKey) =>
	columns(specimen).floats("parameters")[NUMBER_KEYS.indexOf(key)];

describe("a request", () => {
	it("contains its model, its seed and its outputs", () => {
		const fine = { meshes: false, measures: false, stemSides: 7, berrySegments: 20 };
		const request = columns({ ...specimenFromPreset(), seed: 0xfffffffe }, fine);
		expect(request.text("model")).toBe("bunch");
		expect([...request.uint32("seed")]).toEqual([0xfffffffe]);
		expect([...request.uint32("stem_sides"), ...request.uint32("berry_segments")]).toEqual([7, 20]);
		expect(request.floats("parameters")).toHaveLength(NUMBER_KEYS.length);
		expect(request.text("outputs")).toBe("");
		expect(columns(specimenFromPreset()).text("outputs")).toBe("meshes measures sky");
		expect(columns(specimenFromPreset(), { measures: false }).text("outputs")).toBe("meshes sky");
		expect(columns(specimenFromPreset(), { measures: false, sky: false }).text("outputs")).toBe("meshes");
		expect(columns(specimenFromPreset(), { preview: true }).text("outputs")).toBe("meshes");
		expect(columns(specimenFromPreset(), { meshFingerprint: true }).text("outputs")).toBe(
			"meshes measures sky mesh_fingerprint",
		);
	});

	it("brings the procedure's own text where the specimen has none", () => {
		const file = (number: number) => readFileSync(`wasm-core/grammars/bunch/grape-bunch-${number}.lsys`, "utf8");
		expect(columns(specimenFromPreset()).text("grammar")).toBe(file(4));
		expect(columns(specimenFromPreset(undefined, 1)).text("grammar")).toBe(file(3));
	});

	it("leaves a grammar's constants alone unless they were moved; the profile is always given", () => {
		const specimen = withParameters(specimenFromPreset(), { yaw: 45 });
		expect(parameter(specimen, "yaw")).toBe(45);
		expect(parameter(specimen, "roll")).toBeNaN();
		expect(parameter(specimen, "l")).toBe(512);
		expect(parameter(specimen, "fit")).toBe(1);
		expect(parameter(specimen, "wing")).toBe(0);
	});

	it("holds inputs, grammar and the ids of thinned berries", () => {
		const thinned = [7, 2 ** 30 - 1];
		const request = columns({ ...specimenFromPreset(), thinned, inputs: { m: 3, n: [1, 2] }, grammar: "äxiom" });
		expect([...request.ints("m"), ...request.ints("n")]).toEqual([3, 1, 2]);
		expect(request.text("grammar")).toBe("äxiom");
		expect([...request.uint32("thinned")]).toEqual(thinned);
	});

	it("holds a choice by its place", () => {
		const specimen = withParameters(specimenFromPreset(), { procedure: 0, fruit: 4 });
		expect([parameter(specimen, "procedure"), parameter(specimen, "fruit")]).toEqual([0, 4]);
	});

	it("is not made of a specimen that is none", () => {
		const specimen = specimenFromPreset();
		const bad: Specimen[] = [
			{ ...specimen, seed: -1 },
			{ ...specimen, seed: 2 ** 32 },
			{ ...specimen, parameters: { ...specimen.parameters, l: Number.NaN } },
			{ ...specimen, thinned: [0.5] },
			{ ...specimen, thinned: [-1] },
			{ ...specimen, inputs: { m: 2.5 } },
			{ ...specimen, inputs: { m: 3, n: [-1, 2] } },
			{ ...specimen, inputs: { m: 201, n: Array(200).fill(1) } },
			{ ...specimen, grammar: "x".repeat(256 * 1024 + 1) },
		];
		for (const each of bad) expect(() => encodeRequest(each)).toThrow(CoreError);
	});
});
