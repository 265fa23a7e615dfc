import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { exportGlb } from "../../../web/src/export/glb";
import { exportJson } from "../../../web/src/export/json";
import { FILE_BYTES, FileError, specimenFromFile } from "../../../web/src/export/restore";
import * as arbitrary from "./arbitrary";
import { makeGrown, SKETCH, sampleSpecimen } from "./fixture";

const grown = makeGrown(SKETCH);
const specimen = sampleSpecimen({ preset: "rubus", seed: 12, grammar: "axiom: F(1)\n" });
const bytes = (text: string) => new TextEncoder().encode(text);
const glb = await exportGlb(grown, specimen);

describe("a specimen out of a file", () => {
	it("comes back from any GLB and JSON as it went in, without notes", async () => {
		await fc.assert(
			fc.asyncProperty(arbitrary.specimen, fc.boolean(), async (any, instancing) => {
				const files = [await exportGlb(grown, any, { instancing }), bytes(JSON.stringify(exportJson(grown, any)))];
				for (const file of files) expect(specimenFromFile("file", file)).toEqual({ specimen: any, notes: [] });
			}),
			{ numRuns: 40 },
		);
	});

	it("is found by what the file holds, not by its name, also inside a larger buffer", () => {
		const inside = new Uint8Array(glb.length + 5);
		inside.set(glb, 5);
		expect(specimenFromFile("bunch.json", inside.subarray(5)).specimen).toEqual(specimen);
	});

	it("comes back from the text of a glTF", () => {
		const text = JSON.stringify({ asset: { version: "2.0", extras: { specimen } } });
		expect(specimenFromFile("bunch.gltf", bytes(text)).specimen).toEqual(specimen);
	});

	it("is never trusted: what is out of range is changed, with notes", () => {
		const wild = { specimen: { ...specimen, seed: -3, parameters: { ...specimen.parameters, l: 1e9 }, evil: 1 } };
		const { specimen: tame, notes } = specimenFromFile("bunch.json", bytes(JSON.stringify(wild)));
		expect(tame.parameters.l).toBe(580);
		expect(tame.seed).toBe(0);
		expect(notes.map(({ key }) => key).sort()).toEqual(["evil", "l", "seed"]);
	});

	it.each([
		["empty.glb", new Uint8Array(), "empty.glb is empty."],
		["large.glb", new Uint8Array(FILE_BYTES + 1), "large.glb is larger than 64 MiB"],
		["grapes.png", Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0xff), "grapes.png is neither a GLB nor readable JSON"],
		["notes.txt", bytes("a bunch"), "notes.txt is neither a GLB nor readable JSON"],
		["other.json", bytes('{"plan":{}}'), "other.json holds no specimen"],
		["null.json", bytes("null"), "null.json holds no specimen"],
		["list.json", bytes('{"specimen":[1]}'), "list.json holds no specimen"],
		["proto.json", bytes('{"asset":{"extras":"specimen"}}'), "proto.json holds no specimen"],
		["cut.glb", glb.subarray(0, 100), "cut.glb is a damaged or unfinished GLB"],
		["short.glb", glb.subarray(0, 15), "short.glb is a damaged or unfinished GLB"],
		["old.glb", glb.with(4, 1), "old.glb is glTF of version 1"],
		["kind.glb", glb.with(16, 0), "kind.glb is a damaged or unfinished GLB"],
	])("says what is wrong with %s", (name, file, message) => {
		expect(() => specimenFromFile(name, file)).toThrow(FileError);
		expect(() => specimenFromFile(name, file)).toThrow(message);
	});

	it("survives any damage to a file: a specimen or a FileError, never anything else", () => {
		const damage = fc.array(fc.tuple(fc.nat(Math.min(4000, glb.length - 1)), fc.nat(255)), {
			minLength: 1,
			maxLength: 6,
		});
		fc.assert(
			fc.property(damage, fc.nat(glb.length), (changes, length) => {
				const file = glb.slice();
				for (const [at, value] of changes) file[at] = value;
				for (const each of [file, file.subarray(0, length)]) {
					try {
						expect(specimenFromFile("damaged.glb", each).specimen.v).toBe(1);
					} catch (error) {
						expect(error).toBeInstanceOf(FileError);
					}
				}
			}),
			{ numRuns: 300 },
		);
	});
});
