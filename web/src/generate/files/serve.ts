/** The worker's side: makes the requested file. */
import { Core } from "../../core/core";
import { compileCore } from "../../core/loader";
import { messageOf } from "../../locale/message_error";
import { isModel, modelNamed } from "../../models/index";
import type { Model } from "../../models/model";
import { growPlant } from "../growth";
import type { GrowSpecimen } from "./levelled";
import { makeFile } from "./make";
import type { FileRequest, FromExporter } from "./messages";

/** Makes a file and returns the answer to the page. Never throws: the answer holds every error. */
export async function answerTo(request: FileRequest): Promise<FromExporter> {
	if (!isModel(request.model)) return { type: "unknown" };
	const model = await modelNamed(request.model).catch(() => undefined);
	if (!model) return { type: "unfetched" };
	try {
		return { type: "made", file: await makeFile(model, request, growerOf(model, request)) };
	} catch (error) {
		return { type: "failed", message: messageOf(error) };
	}
}

/** Returns a function that grows with a core of its own; undefined where the core's address is unknown. */
function growerOf(model: Model, { core: address }: FileRequest): GrowSpecimen | undefined {
	if (address === undefined) return undefined;
	let core: Promise<Core> | undefined;
	return (specimen, wanted) =>
		growPlant(model, specimen, { measures: false, ...wanted }, async (_, blocks) => {
			core ??= compileCore(address).then(Core.instantiate);
			return (await core).grow(blocks);
		});
}
