/** The files of a grown plant, as bytes: what `Download` gives but for pictures. Runs in a worker, or anywhere. */
import { aboutPlant } from "../export/about_plant";
import { exportGlb } from "../export/glb";
import { exportJson } from "../export/json";
import { exportObj } from "../export/obj";
import type { Model } from "../models/model";
import type { FileRequest, MadeFile } from "./messages";
import { zip } from "./zip";

/**
 * Makes a file. The same request gives the same bytes.
 * @throws RangeError where neither every plant nor the model has such a file, and what the making throws
 */
export async function makeFile(model: Model, request: FileRequest): Promise<MadeFile> {
	const { format, grown, specimen, link, name } = request;
	if (format === "json") return json(model, request);
	const own = model.formats?.find(({ key }) => key === format);
	if (own) return { bytes: bytesOf(await own.make(grown, specimen, link)), type: own.type };
	const about = await aboutPlant(model, grown, specimen, link);
	const parts = model.parts(grown, specimen);
	if (format === "glb" || format === "glb-instanced") {
		return { bytes: exportGlb(parts, about, { instancing: format !== "glb" }), type: "model/gltf-binary" };
	}
	if (format !== "obj") throw new RangeError(`There is no file “${format}” of a ${model.noun}.`);
	const { obj, mtl } = exportObj(parts, about, name);
	const both = [
		{ name: `${name}.obj`, bytes: bytesOf(obj) },
		{ name: `${name}.mtl`, bytes: bytesOf(mtl) },
	];
	return { bytes: zip(both), type: "application/zip" };
}

function json(model: Model, { grown, specimen }: FileRequest): MadeFile {
	const document = JSON.stringify(exportJson(model, grown, specimen), null, "\t");
	return { bytes: bytesOf(`${document}\n`), type: "application/json" };
}

function bytesOf(data: string | Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
	return typeof data === "string" ? new TextEncoder().encode(data) : data;
}
