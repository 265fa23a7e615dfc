/** The files of a grown plant: all that `Download` offers except pictures. Runs in a worker, or anywhere. */
import { aboutPlant } from "../../formats/about_plant";
import { writeJson } from "../../formats/json";
import { writeObj } from "../../formats/obj";
import { PLANT_FILES } from "../../formats/plant_files";
import { MessageError } from "../../locale/message_error";
import type { Model } from "../../models/model";
import { text } from "../messages.generated";
import { agedOf } from "./aged";
import { type GrowSpecimen, levelledOf } from "./levelled";
import type { FileRequest } from "./messages";
import { swayed } from "./swayed";
import { zip } from "./zip";

const encoder = new TextEncoder();

/**
 * Makes a file. The same request gives the same bytes.
 * @param grow for files that show the plant at many ages or levels of detail
 * @throws RangeError where neither all plants nor the model have such a file, and errors of the writer
 */
export async function makeFile(model: Model, request: FileRequest, grow?: GrowSpecimen): Promise<Blob> {
	const { format, grown, specimen, link, name, options } = request;
	if (format === "json") return json(model, request);
	const own = model.formats?.find(({ key }) => key === format);
	if (own) return new Blob([await own.make(grown, specimen, link)], { type: own.type });
	const about = await aboutPlant(model, grown, specimen, link);
	const file = PLANT_FILES.find(({ key }) => key === format);
	const parts = model.parts(grown, specimen);
	if (file) {
		const aged = file.life && grow ? agedOf(model, specimen, grow) : undefined;
		const levels = file.levelled && grow ? levelledOf(model, specimen, grow) : undefined;
		const further = { aged, levels, sway: swayed(model, grown), plant: grown };
		return new Blob([await file.make(parts, about, options ?? {}, further)], { type: file.type });
	}
	if (format !== "obj") throw new MessageError(text.message("format_unknown", { format }));
	const { obj, mtl, pictures } = writeObj(parts, about, name);
	const all = [
		{ name: `${name}.obj`, bytes: obj.bytes() },
		{ name: `${name}.mtl`, bytes: encoder.encode(mtl) },
		...pictures,
	];
	return new Blob([zip(all)], { type: "application/zip" });
}

/** Makes the JSON file of a plant, indented with tabs. */
function json(model: Model, { grown, specimen }: FileRequest): Blob {
	return new Blob([...writeJson(model, grown, specimen, "\t").chunks(), "\n"], { type: "application/json" });
}
