import { describe, expect, it } from "vitest";
import { CoreError } from "../../../web/src/core/errors";
import { encodeRequest } from "../../../web/src/models/bunch/request";
import { withParameters } from "../../../web/src/specimen/edit";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
import { NUMBER_KEYS, type NumberKey } from "../../../web/src/models/bunch/parameters.generated";
import type { Specimen } from "../../../web/src/specimen/specimen";

const HEADER = 12;
const view = (specimen: Specimen, options?: Parameters<typeof encodeRequest>[1]) =>
	new DataView(encodeRequest(specimen, options).buffer);
const word = (data: DataView, index: number) => data.getUint32(index * 4, true);
const parameter = (specimen: Specimen, key: NumberKey) =>
	view(specimen).getFloat32((HEADER + NUMBER_KEYS.indexOf(key)) * 4, true);

describe("a request", () => {
	it("begins with its header", () => {
		const data = view(
			{ ...specimenFromPreset(), seed: 0xfffffffe },
			{ meshes: false, measures: false, stemSides: 7, berrySegments: 20 },
		);
		const header = Array.from({ length: HEADER }, (_, index) => word(data, index));
		expect(header).toEqual([0x4c434e50, 2, 1, 0, 0xfffffffe, 7, 20, NUMBER_KEYS.length, 0, 0, 0, 0]);
		expect(data.byteLength).toBe((HEADER + NUMBER_KEYS.length) * 4);
		expect(word(view(specimenFromPreset()), 3)).toBe(1 | 2);
		expect(word(view(specimenFromPreset(), { measures: false }), 3)).toBe(1);
		expect(word(view(specimenFromPreset(), { meshes: false }), 3)).toBe(2);
	});

	it("leaves a grammar's constants alone unless they were moved; the profile is always given", () => {
		const specimen = withParameters(specimenFromPreset(), { yaw: 45 });
		expect(parameter(specimen, "yaw")).toBe(45);
		expect(parameter(specimen, "roll")).toBeNaN();
		expect(parameter(specimen, "l")).toBe(512);
		expect(parameter(specimen, "fit")).toBe(1);
		expect(parameter(specimen, "wing")).toBe(0);
	});

	it("holds inputs and grammar, padded to a word", () => {
		const data = view({ ...specimenFromPreset(), inputs: { m: 3, n: [1, 2] }, grammar: "äxiom" });
		expect([word(data, 8), word(data, 9), word(data, 10)]).toEqual([3, 2, 6]);
		const n = HEADER + NUMBER_KEYS.length;
		expect([word(data, n), word(data, n + 1)]).toEqual([1, 2]);
		expect(data.byteLength).toBe((n + 2 + 2) * 4);
		const text = new Uint8Array(data.buffer, (n + 2) * 4);
		expect(new TextDecoder().decode(text)).toBe("äxiom\0\0");
	});

	it("holds a choice by its place, and the ids of thinned berries after n and before the grammar", () => {
		const specimen = withParameters(specimenFromPreset(), { procedure: 0, fruit: 4 });
		expect([parameter(specimen, "procedure"), parameter(specimen, "fruit")]).toEqual([0, 4]);
		const data = view({ ...specimen, thinned: [7, 2 ** 30 - 1], inputs: { m: 2, n: [5] }, grammar: "abcd" });
		expect([word(data, 9), word(data, 10), word(data, 11)]).toEqual([1, 4, 2]);
		const n = HEADER + NUMBER_KEYS.length;
		expect([0, 1, 2].map((at) => word(data, n + at))).toEqual([5, 7, 2 ** 30 - 1]);
		expect(new TextDecoder().decode(new Uint8Array(data.buffer, (n + 3) * 4))).toBe("abcd");
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
