import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { alike } from "../../../../web/src/formats/alike";
import { exportGlb } from "../../../../web/src/formats/glb";
import { exportJson } from "../../../../web/src/formats/json";
import { exportObj } from "../../../../web/src/formats/obj";
import { makeFile } from "../../../../web/src/generate/files/make";
import type { FileRequest } from "../../../../web/src/generate/files/messages";
import { answerTo } from "../../../../web/src/generate/files/serve";
import { berriesCsv } from "../../../../web/src/models/bunch/tables";
import type { Model } from "../../../../web/src/models/model";
import { bunchModel } from "../../app/context";
import { specimenFromPreset } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";
import { documentOf } from "../../formats/reading";

const specimen = { ...specimenFromPreset("duku"), seed: 3 };
const link = "https://example.org/?v=2&preset=duku&seed=3";

/** A request as a worker has it: the page's, cloned. */
async function request(format: string) {
	const bunch = growBunch(await freshCore(), specimen);
	return {
		bunch,
		requested: structuredClone({ model: "bunch", format, grown: bunch, specimen, link, name: "duku-3" }),
	};
}

async function made(requested: FileRequest) {
	const file = await makeFile(bunchModel, requested);
	return { bytes: new Uint8Array(await file.arrayBuffer()), type: file.type };
}

describe("a file made of a clone", () => {
	it.each(["glb", "glb-instanced"])("is the very %s of the plant", async (format) => {
		const { bunch, requested } = await request(format);
		const about = await aboutPlant(bunchModel, bunch, specimen, link);
		const parts = [...bunchModel.parts(bunch, specimen)];
		const expected = exportGlb(format === "glb" ? parts : parts.map(alike), about, { instancing: format !== "glb" });
		const { bytes, type } = await made(requested);
		expect(type).toBe("model/gltf-binary");
		expect(Buffer.from(bytes).equals(expected)).toBe(true);
	});

	it("wants readers that know instances only where they are asked for", async () => {
		// The paper's berries share a mesh.
		const paper = specimenFromPreset("duku", 1);
		const grown = structuredClone(growBunch(await freshCore(), paper));
		const wants = async (format: string) => {
			const { bytes } = await made({ model: "bunch", format, grown, specimen: paper, link, name: "duku-1" });
			return documentOf(bytes).extensionsRequired ?? [];
		};
		expect(await wants("glb")).toEqual([]);
		expect(await wants("glb-instanced")).toEqual(["EXT_mesh_gpu_instancing"]);
	});

	it("is its OBJ and MTL in an archive", async () => {
		const { bunch, requested } = await request("obj");
		const about = await aboutPlant(bunchModel, bunch, specimen, link);
		const { obj, mtl } = exportObj(bunchModel.parts(bunch, specimen), about, "duku-3");
		const { bytes, type } = await made(requested);
		const files = unzipSync(bytes);
		expect(type).toBe("application/zip");
		const pictures = ["Stem", "Skin"].map((material) => `duku-3-${material}-colour.png`);
		expect(Object.keys(files)).toEqual(["duku-3.obj", "duku-3.mtl", ...pictures]);
		expect(strFromU8(files["duku-3.obj"]) === obj).toBe(true);
		expect(strFromU8(files["duku-3.mtl"])).toBe(mtl);
	});

	it("is its JSON, laid out in lines", async () => {
		const { bunch, requested } = await request("json");
		const { bytes } = await made(requested);
		expect(strFromU8(bytes)).toBe(`${JSON.stringify(exportJson(bunchModel, bunch, specimen), null, "\t")}\n`);
	});

	it("is what the model alone makes", async () => {
		const { bunch, requested } = await request("csv");
		const { bytes, type } = await made(requested);
		expect([type, strFromU8(bytes)]).toEqual(["text/csv", berriesCsv(bunch, specimen)]);
	});
});

describe("the worker's answer", () => {
	it("is the file", async () => {
		const { requested } = await request("json");
		const answer = await answerTo(requested);
		if (answer.type !== "made") throw new Error(answer.type);
		expect(await answer.file.text()).toBe(await (await makeFile(bunchModel, requested)).text());
	});

	it("tells a model that it does not know, and what went wrong", async () => {
		const { requested } = await request("fbx");
		expect(await answerTo({ ...requested, model: "toy" })).toEqual({ type: "unknown" });
		expect(await answerTo(requested)).toEqual({
			type: "failed",
			message: {
				code: "generate.format_unknown",
				args: { format: "fbx" },
				text: "There is no file format “fbx” for this plant.",
			},
		});
		const broken = { ...bunchModel, parts: () => undefined } as unknown as Model;
		await expect(makeFile(broken, { ...requested, format: "glb" })).rejects.toThrow();
	});
});
