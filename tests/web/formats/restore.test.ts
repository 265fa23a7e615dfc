import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { FileError, JSON_BYTES } from "../../../web/src/formats/restore";
import { inRun } from "../../long_run.mjs";
import { exportJson, specimenFromFile } from "../bunch";
import * as arbitrary from "../models/bunch/arbitrary";
import { makeGrown, SKETCH, sampleSpecimen } from "../models/bunch/fixture";
import { bunchGlb } from "../models/bunch/parts/files";

const grown = makeGrown(SKETCH);
const specimen = sampleSpecimen({ preset: "rubus", seed: 12, thinned: [77, 5, 2 ** 30 - 1], grammar: "axiom: F(1)\n" });
const glb = await bunchGlb(grown, specimen);
const open = (name: string, ...parts: BlobPart[]) => specimenFromFile(name, new Blob(parts));

/** A file that is larger than its content; records the ranges that were read. */
class LargeFile extends Blob {
	readonly read: [from: number, to: number][] = [];
	constructor(
		parts: BlobPart[],
		readonly claimed: number,
	) {
		super(parts);
	}
	override get size() {
		return this.claimed;
	}
	override slice(from: number, to: number): Blob {
		this.read.push([from, to]);
		return to - from > JSON_BYTES ? new LargeFile([], to - from) : super.slice(from, to);
	}
	override arrayBuffer(): Promise<ArrayBuffer> {
		throw new Error("read whole");
	}
}

/** The GLB with other numbers in its header: bytes of the file, of the JSON chunk. */
function headed(file: number, json?: number): Uint8Array<ArrayBuffer> {
	const copy = glb.slice();
	const header = new DataView(copy.buffer);
	header.setUint32(8, file, true);
	if (json !== undefined) header.setUint32(12, json, true);
	return copy;
}

describe("a specimen out of a file", () => {
	it("comes back from any GLB and JSON as it went in, without notes", async () => {
		await fc.assert(
			fc.asyncProperty(arbitrary.specimen, fc.boolean(), async (any, instancing) => {
				const files = [await bunchGlb(grown, any, { instancing }), JSON.stringify(exportJson(grown, any))];
				for (const file of files) expect(await open("file", file)).toEqual({ specimen: any, notes: [] });
			}),
			{ numRuns: 40 },
		);
	});

	it("is found by what the file holds, not by its name", async () => {
		expect((await open("bunch.json", glb)).specimen).toEqual(specimen);
	});

	it("is read out of a GLB of any size, and nothing but its beginning and its JSON are", async () => {
		const size = 4_000_000_000;
		const file = new LargeFile([headed(size)], size);
		expect((await specimenFromFile("large.glb", file)).specimen).toEqual(specimen);
		const json = new DataView(glb.buffer).getUint32(12, true);
		expect(file.read).toEqual([
			[0, 8],
			[0, 20],
			[20, 20 + json],
		]);
	});

	it("is not looked for in more JSON than an export can have", async () => {
		const size = JSON_BYTES + 1000;
		for (const parts of [[headed(size, JSON_BYTES + 1)], ["{}"]]) {
			const reading = specimenFromFile("large", new LargeFile(parts, size));
			await expect(reading).rejects.toThrow("large is too large. Open a GLB, JSON or PNG exported from Panicle.");
		}
	});

	it("comes back from the text of a glTF", async () => {
		const text = JSON.stringify({ asset: { version: "2.0", extras: { specimen } } });
		expect((await open("bunch.gltf", text)).specimen).toEqual(specimen);
	});

	it("is never trusted: what is out of range is changed, with notes", async () => {
		const wild = { specimen: { ...specimen, seed: -3, parameters: { ...specimen.parameters, l: 1e9 }, evil: 1 } };
		const { specimen: tame, notes } = await open("bunch.json", JSON.stringify(wild));
		expect(tame.parameters.l).toBe(580);
		expect(tame.seed).toBe(0);
		expect(notes.map(({ key }) => key).sort()).toEqual(["evil", "l", "seed"]);
	});

	it.each([
		["empty.glb", new Uint8Array(), "empty.glb is empty."],
		["grapes.png", Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0xff), "grapes.png is neither a GLB nor readable JSON"],
		["notes.txt", "a bunch", "notes.txt is neither a GLB nor readable JSON"],
		["other.json", '{"plan":{}}', "other.json wasn’t made by Panicle"],
		["null.json", "null", "null.json wasn’t made by Panicle"],
		["list.json", '{"specimen":[1]}', "list.json wasn’t made by Panicle"],
		["proto.json", '{"asset":{"extras":"specimen"}}', "proto.json wasn’t made by Panicle"],
		["cut.glb", glb.subarray(0, 100), "cut.glb is damaged or incomplete"],
		// All of the JSON is there, of the meshes all but a byte.
		["nearly.glb", glb.subarray(0, glb.length - 1), "nearly.glb is damaged or incomplete"],
		["short.glb", glb.subarray(0, 15), "short.glb is damaged or incomplete"],
		["old.glb", glb.with(4, 1), "old.glb is glTF version 1;"],
		["kind.glb", glb.with(16, 0), "kind.glb is damaged or incomplete"],
	])("says what is wrong with %s", async (name, file, message) => {
		await expect(open(name, file)).rejects.toThrow(FileError);
		await expect(open(name, file)).rejects.toThrow(message);
	});

	it("survives any damage to a file: a specimen or a FileError, never anything else", async () => {
		const damage = fc.array(fc.tuple(fc.nat(Math.min(4000, glb.length - 1)), fc.nat(255)), {
			minLength: 1,
			maxLength: 6,
		});
		await fc.assert(
			fc.asyncProperty(damage, fc.nat(glb.length), async (changes, length) => {
				const file = glb.slice();
				for (const [at, value] of changes) file[at] = value;
				for (const each of [file, file.subarray(0, length)]) {
					try {
						expect((await open("damaged.glb", each)).specimen.v).toBe(2);
					} catch (error) {
						expect(error).toBeInstanceOf(FileError);
					}
				}
			}),
			{ numRuns: inRun(100, 300) },
		);
	});
});
