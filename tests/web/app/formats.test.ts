import { describe, expect, it, vi } from "vitest";
import { downloadFormats, fileName } from "../../../web/src/app/files/formats";
import { png } from "../../../web/src/formats/png";
import { foundInFile } from "../../../web/src/formats/restore";
import { makeFile } from "../../../web/src/generate/files/make";
import type { FileRequest } from "../../../web/src/generate/files/messages";
import type { Format } from "../../../web/src/models/model";
import type { PageModel } from "../../../web/src/models/page_model";
import { model as standModel } from "../../../web/src/models/stand/index";
import { EMPTY_PLANT, type Plant } from "../../../web/src/plant/plant";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { specimenFromPreset } from "../bunch";
import { toy } from "../toy";
import { bunchModel } from "./context";

const model = toy as unknown as PageModel;
const stand: PageModel = { ...(standModel as unknown as PageModel), instanced: () => false };
const shown = (formats: readonly Format[]) => ({
	model: { ...model, formats },
	grown: EMPTY_PLANT,
	from: fromPreset(model),
});
const format: Format = {
	key: "txt",
	title: "Text",
	about: "In words",
	suffix: ".txt",
	type: "text/plain",
	make: async (_, { preset }, link) => `${preset} ${link}`,
};

it("names files after preset and seed", () => {
	expect(fileName({ ...specimenFromPreset("grape-15a"), seed: 7 })).toBe("grape-15a-7");
	expect(fileName({ ...specimenFromPreset("grape-15a"), seed: 7 }, true)).toBe("grape-15a-altered-7");
});

describe("what can be downloaded", () => {
	it("is the formats of every plant, and pictures if there is a view", () => {
		const keys = (picture?: () => Promise<Blob>) => downloadFormats(shown([]), picture).map(({ key }) => key);
		expect(keys()).toEqual(["glb", "glb-web", "glb-low", "glb-wind", "usdz", "ply", "3mf", "stl", "obj", "json"]);
		expect(keys(async () => new Blob())).toEqual([
			"glb",
			"glb-web",
			"glb-low",
			"glb-wind",
			"usdz",
			"ply",
			"3mf",
			"stl",
			"obj",
			"json",
			"png",
			"png-alone",
		]);
	});

	it("does not include wind animations for models that do not sway", () => {
		expect(downloadFormats({ ...shown([]), model: stand }, undefined).map(({ key }) => key)).not.toContain("glb-wind");
	});

	it("includes pictures of the requested height, with or without background", async () => {
		const take = vi.fn(async () => new Blob());
		const pictures = downloadFormats(shown([]), take).filter(({ key }) => key.startsWith("png"));
		const request = { plant: shown([]), link: "", name: "a", options: {} };
		for (const { make } of pictures) await make({ ...request, options: { height: 300 } });
		await pictures[1].make(request);
		expect(take.mock.calls).toEqual([[{ height: 300 }], [{ height: 300, alone: true }], [{ alone: true }]]);
	});

	it("includes pictures that contain the plant’s link", async () => {
		const taken = new Blob([png({ width: 1, height: 1, pixels: new Uint8Array(3) })]);
		const pictures = downloadFormats(shown([]), async () => taken).filter(({ key }) => key.startsWith("png"));
		for (const { make } of pictures) {
			const file = await make({ plant: shown([]), link: "https://a.example/?v=2", name: "a", options: {} });
			expect(await foundInFile("a.png", file)).toEqual({ link: "https://a.example/?v=2" });
		}
	});

	it("includes its growth if it has an age and its core is part of the page", () => {
		const from = specimenFromPreset("riesling");
		const keys = (wasm: string) =>
			downloadFormats({ model: { ...bunchModel, wasm }, grown: EMPTY_PLANT, from }, undefined).map(({ key }) => key);
		expect(keys(bunchModel.wasm)).toContain("glb-growth");
		expect(keys("nowhere.wasm")).not.toContain("glb-growth");
	});

	it("includes a file with instances if parts share meshes", () => {
		const organs = { ...EMPTY_PLANT.organs, count: 1, mesh: Int32Array.of(0) };
		const keys = (model: Partial<PageModel>, grown: Plant = { ...EMPTY_PLANT, organs }) =>
			downloadFormats({ ...shown([]), model: { ...shown([]).model, ...model }, grown }, undefined).map(
				({ key }) => key,
			);
		expect(keys({})).toContain("glb-instanced");
		expect(keys({ instanced: () => false })).not.toContain("glb-instanced");
		expect(keys({ instanced: () => true }, EMPTY_PLANT)).toContain("glb-instanced");
	});

	it("includes the model's own formats that apply", async () => {
		const plant = shown([format, { ...format, key: "no", applies: () => false }]);
		const write = vi.fn((model: PageModel, request: FileRequest) => makeFile(model, request));
		const [own, ...others] = downloadFormats(plant, undefined, write).filter(
			({ key }) => key === "txt" || key === "no",
		);
		expect(others).toEqual([]);
		const blob = await own.make({ plant, link: "?v=2", name: "plain-1", options: { triangles: 500 } });
		expect([blob.type, await blob.text()]).toEqual(["text/plain", "plain ?v=2"]);
		expect(write.mock.lastCall?.[1]).toMatchObject({
			model: "toy",
			format: "txt",
			name: "plain-1",
			options: { triangles: 500 },
		});
	});
});
