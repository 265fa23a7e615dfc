import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { independentDraws } from "../../../web/src/batch/draws";
import { zipOf } from "../../../web/src/batch/series_zip";
import { readVary } from "../../../web/src/batch/vary";
import { run } from "../../../web/src/cli/run";
import { makeFile } from "../../../web/src/generate/files/make";
import { model as bunch } from "../../../web/src/models/bunch/index";
import type { Model } from "../../../web/src/models/model";
import { withParameters } from "../../../web/src/specimen/edit";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { memoryWorld } from "../cli/world";
import { freshCore } from "../core/wasm";

const model = bunch as unknown as Model;
const from = withParameters(model, fromPreset(model, "redcurrant"), { count: 5 });
const series = {
	model,
	from,
	varied: readVary(model, "age=60..110", from),
	draws: independentDraws(model, from),
	formats: ["glb"],
};
const core = await freshCore();
const means: Parameters<typeof zipOf>[2] = {
	grow: async (of, specimen, options) => of.read(core.grow(of.encode(specimen, options)), specimen),
	make: makeFile,
};
const watching = () => {
	const cancel = new AbortController();
	const reported: number[] = [];
	return { cancel, reported, signal: cancel.signal, progress: (done: number) => void reported.push(done) };
};

describe("a series as one archive", () => {
	it("holds what the command line puts into a folder, byte for byte", async () => {
		const watch = watching();
		const archive = unzipSync(new Uint8Array(await (await zipOf(series, [1, 2], means, watch)).arrayBuffer()));
		expect(watch.reported).toEqual([1, 2]);
		const { world, written } = memoryWorld();
		await run(["redcurrant", "--set", "count=5", "--seeds", "1-2", "--vary", "age=60..110", "--out", "."], world);
		expect(Object.keys(archive).sort()).toEqual([...written.keys()].sort());
		for (const [name, data] of written) expect(Buffer.from(archive[name]).equals(Buffer.from(data))).toBe(true);
	});

	it("ends when it is cancelled", async () => {
		const watch = watching();
		const progress = (done: number) => done === 2 && watch.cancel.abort(new Error("enough"));
		await expect(zipOf(series, [1, 2, 3], means, { ...watch, progress: progress as never })).rejects.toThrow("enough");
	});

	it("has a line for a plant that could not be grown", async () => {
		const make: typeof means.make = (of, request) =>
			request.name.endsWith("-1") ? Promise.reject(new Error("no room")) : makeFile(of, request);
		const archive = unzipSync(
			new Uint8Array(await (await zipOf(series, [1, 2], { ...means, make }, watching())).arrayBuffer()),
		);
		expect(Object.keys(archive)).toEqual(["redcurrant-2.glb", "plants.csv", "series.json"]);
		expect(strFromU8(archive["plants.csv"]).split("\r\n")[1]).toMatch(/^1,\d+,,,,.*,no room$/);
	});

	it("is refused where none could be grown, with why", async () => {
		const make = () => Promise.reject(new Error("no room."));
		await expect(zipOf(series, [1, 2], { ...means, make }, watching())).rejects.toThrow(
			"None of the 2 plants could be grown: no room",
		);
	});

	it("is refused where it would hold too many", async () => {
		const numbers = Array.from({ length: 1001 }, (_, number) => number);
		await expect(zipOf(series, numbers, means, watching())).rejects.toThrow(/An archive can hold at most 1,000 plants/);
	});
});
