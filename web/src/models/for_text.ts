/**
 * Finds the model for a grammar's text that comes without a model's name: a file on the command line, or dropped on the
 * page. The comment in the file decides, then the text itself, then the suffix of the file's name; every other text
 * goes to the model that takes any.
 */
import { modelInQuery } from "../specimen/link";
import type { Specimen } from "../specimen/specimen";
import { readTextFile, specimenOf, type TextFile } from "../specimen/text_file";
import { isModel, modelNamed, modelNames } from "./index";
import type { Model } from "./model";

/** A grammar's text and the model that it is for. */
export interface ReadText {
	/** Undefined where no model takes the text. */
	readonly model: Model | undefined;
	/** The text in the notation of that model, translated where the file had another form. */
	readonly text: string;
	/** The specimen that the file describes besides its text; undefined where it describes none. */
	readonly specimen: Specimen | undefined;
}

/**
 * Reads a grammar's text and finds its model.
 * @param fileName the file's name, with a suffix such as `.growth`
 * @throws TextError where the text is in a translatable form and has a mistake
 */
export async function readText(contents: string, fileName = ""): Promise<ReadText> {
	const file = readTextFile(contents);
	const model = (await modelNamedIn(file)) ?? (await modelForText(file.text, fileName));
	const text = (await model?.translated?.(file.text)) ?? file.text;
	return { model, text, specimen: model && specimenOf(model, file) };
}

/** Returns the model that a file names, if that model grows by a text. */
async function modelNamedIn({ query }: TextFile): Promise<Model | undefined> {
	const named = query === undefined ? undefined : modelInQuery(query);
	if (named === undefined || !isModel(named)) return undefined;
	const model = await modelNamed(named);
	return model.details.some(({ packed }) => packed?.key === "grammar") ? model : undefined;
}

/** Returns the model that claims a text, else the one with this suffix of files, else the one that takes any text. */
export async function modelForText(text: string, fileName = ""): Promise<Model | undefined> {
	const models = await Promise.all(modelNames().map(modelNamed));
	const ending = /\.\w+$/.exec(fileName.toLowerCase())?.[0];
	return (
		models.find(({ details }) => details.some(({ claims }) => claims?.(text))) ??
		models.find(({ formats = [] }) => formats.some(({ suffix }) => suffix === ending)) ??
		models.find(({ details }) => details.some(({ takesAny }) => takesAny))
	);
}
