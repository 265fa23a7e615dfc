/** The worker's side: makes the file that is asked for. */
import { isModel, modelNamed } from "../models/index";
import { makeFile } from "./make";
import type { FileRequest, FromExporter } from "./messages";

/** Never throws: whatever goes wrong is in the answer. */
export async function answerTo(request: FileRequest): Promise<FromExporter> {
	if (!isModel(request.model)) return { type: "unknown" };
	const model = await modelNamed(request.model).catch(() => undefined);
	if (!model) return { type: "unfetched" };
	try {
		return { type: "made", file: await makeFile(model, request) };
	} catch (error) {
		return { type: "failed", message: error instanceof Error ? error.message : String(error) };
	}
}
