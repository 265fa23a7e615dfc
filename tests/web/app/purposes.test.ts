import { describe, expect, it } from "vitest";
import { type DownloadFormat, downloadFormats } from "../../../web/src/app/files/formats";
import { groupedFormats, recommendedFormats } from "../../../web/src/app/files/purposes";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { bunchModel } from "./context";

const picture = async () => new Blob();
const measured = { ...EMPTY_PLANT, measures: new Float32Array() };
const bunch = { model: bunchModel, grown: measured, from: fromPreset(bunchModel) };
const recommended = (formats: readonly DownloadFormat[], canMake?: (format: DownloadFormat) => boolean) =>
	Object.fromEntries(recommendedFormats(formats, canMake).map(({ purpose, format }) => [purpose, format.key]));

describe("recommended formats", () => {
	it("are one for each purpose", () => {
		expect(recommended(downloadFormats(bunch, picture))).toEqual({
			program: "glb",
			website: "glb-web",
			game: "glb-low",
			printing: "3mf",
			ar: "usdz",
			picture: "png",
			data: "csv",
		});
	});

	it("leave out purposes without a suitable format", () => {
		const keys = Object.keys(recommended(downloadFormats(bunch, undefined)));
		expect(keys).not.toContain("picture");
		expect(keys).toHaveLength(6);
	});

	it("are the next suitable format if the file of the first cannot be made", () => {
		const { data, program } = recommended(downloadFormats(bunch, picture), ({ key }) => key !== "csv" && key !== "glb");
		expect([data, program]).toEqual(["json", "obj"]);
		expect(recommended(downloadFormats(bunch, picture), () => false).ar).toBe("usdz");
	});

	it("name the programs that open the file", () => {
		const game = recommendedFormats(downloadFormats(bunch, picture)).find(({ purpose }) => purpose === "game");
		expect(game?.title).toBe("Game");
		expect(game?.openedBy).toMatch(/Unity.*Unreal Engine.*Godot/);
	});
});

describe("groups of formats", () => {
	it.each(modelNames())("contain each format of the model %s once", async (name) => {
		const model = await modelNamed(name);
		const plant = { model: { ...model, instanced: () => true }, grown: measured, from: fromPreset(model) };
		const formats = downloadFormats(plant, picture);
		const grouped = groupedFormats(formats).flatMap((group) => group.formats.map(({ key }) => key));
		expect(grouped.toSorted()).toEqual(formats.map(({ key }) => key).toSorted());
	});

	it("are by kind, without empty ones", () => {
		const groups = groupedFormats(downloadFormats(bunch, picture));
		const keys = Object.fromEntries(groups.map(({ title, formats }) => [title, formats.map(({ key }) => key)]));
		expect(keys).toEqual({
			"3D models": ["glb", "glb-web", "glb-low", "glb-instanced", "usdz", "ply", "obj"],
			Animations: expect.arrayContaining(["glb-wind"]),
			"3D printing": ["3mf", "stl"],
			Pictures: ["png", "png-alone"],
			"Data and text": ["json", "csv", "csv-measures"],
		});
		expect(groupedFormats(downloadFormats(bunch, undefined)).map(({ title }) => title)).not.toContain("Pictures");
	});
});
