/** The worker's side: makes the file that is asked for. */
import { Core } from "../core/core";
import { compileCore } from "../core/loader";
import { isModel, modelNamed } from "../models/index";
import { type CoreAt, makeFile } from "./make";
import type { FileRequest, FromExporter } from "./messages";

const coreAt: CoreAt = async (address) => Core.instantiate(await compileCore(address));

/** Never throws: whatever goes wrong is in the answer. */
export async function answerTo(request: FileRequest): Promise<FromExporter> {
	if (!isModel(request.model)) return { type: "unknown" };
	const model = await modelNamed(request.model).catch(() => undefined);
	if (!model) return { type: "unfetched" };
	try {
		return { type: "made", file: await makeFile(model, request, coreAt) };
	} catch (error) {
		return { type: "failed", message: error instanceof Error ? error.message : String(error) };
	}
}
