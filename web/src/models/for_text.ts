/**
 * Which model a grammar's text is for that comes without a name: a file on the command line, or dropped on the page. What the file says of
 * itself decides, then the text, then the ending of the file's name; the model for any text takes what is left.
 */
import { modelInQuery } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";
import { readTextFile, specimenOf, type TextFile } from "../specimen/text_file";
import { isModel, modelNamed, modelNames } from "./index";
import type { Model } from "./model";

/** A text and the model that it is for. */
export interface ReadText {
	/** Undefined where no model takes it. */
	readonly model: Model | undefined;
	/** As that model's grammars are written, where it came in another form of them. */
	readonly text: string;
	/** What the file says besides its text; undefined where it says nothing. */
	readonly specimen: Specimen | undefined;
}

/**
 * @param fileName the file's name, with an ending such as `.growth`
 * @throws TextError where the form that the text came in has a mistake
 */
export async function readText(said: string, fileName = ""): Promise<ReadText> {
	const file = readTextFile(said);
	const model = (await modelNamedIn(file)) ?? (await modelForText(file.text, fileName));
	const text = (await model?.translated?.(file.text)) ?? file.text;
	return { model, text, specimen: model && specimenOf(model, file) };
}

/** The model that a file says it is of, where that grows by a text. */
async function modelNamedIn({ query }: TextFile): Promise<Model | undefined> {
	const named = query === undefined ? undefined : modelInQuery(query);
	if (named === undefined || !isModel(named)) return undefined;
	const model = await modelNamed(named);
	return model.details.some(({ packed }) => packed?.key === "grammar") ? model : undefined;
}

/** The model that claims a text, else the one whose files end so, else the one that takes any. */
export async function modelForText(text: string, fileName = ""): Promise<Model | undefined> {
	const models = await Promise.all(modelNames().map(modelNamed));
	const ending = /\.\w+$/.exec(fileName.toLowerCase())?.[0];
	return (
		models.find(({ details }) => details.some(({ claims }) => claims?.(text))) ??
		models.find(({ formats = [] }) => formats.some(({ suffix }) => suffix === ending)) ??
		models.find(({ details }) => details.some(({ takesAny }) => takesAny))
	);
}
