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

/**
 * The same, and the text as that model's grammars are written, where it came in another form of them.
 * @throws TextError where that form has a mistake
 */
export async function readText(text: string): Promise<{ model: Model | undefined; text: string }> {
	const model = await modelForText(text);
	return { model, text: (await model?.translated?.(text)) ?? text };
}
