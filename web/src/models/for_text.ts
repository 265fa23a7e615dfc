/** Which model a grammar's text is for that comes without a name: a file on the command line, or dropped on the page. */
import { modelNamed, modelNames } from "./index";
import type { Model } from "./model";

/** The first model that claims it; undefined where none does. */
export async function modelForText(text: string): Promise<Model | undefined> {
	for (const name of modelNames()) {
		const model = await modelNamed(name);
		if (model.details.some(({ claims }) => claims?.(text))) return model;
	}
	return undefined;
}
