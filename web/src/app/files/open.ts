import { readText } from "../../models/for_text";
import { modelNamed, modelNames } from "../../models/index";
import { fromPreset } from "../../specimen/from_preset";
import { fileLengthProblem, textLengthProblem } from "../../specimen/limits";
import { decodeLink, linkParts, modelInQuery } from "../../specimen/link";
import { modelIn, restore } from "../../specimen/restore";
import { SPECIMEN_VERSION } from "../../specimen/specimen";
import { TextError } from "../../specimen/text_error";
import { FILE_TOPIC } from "../../ui/tool";
import { text } from "../messages.generated";
import { EMPTY_MODEL_UI } from "../model_uis";
import { applying } from "../panel_groups";
import { SAVED } from "../parts/late_parts";
import { openPart } from "../parts/open_part";
import type { SavedDialog } from "../parts/saved_dialog";
import type { Studio } from "../studio";
import { fetchFailed } from "../types";
import { dropsOf } from "./drops";

/**
 * Opens the specimen of a GLB, a JSON or a picture with a link, of any model. A file of saved specimens goes to the
 * library, a file without a specimen to the tool that takes it. Errors are shown as notices, and the plant stays.
 */
export async function openFile(studio: Studio, file: File): Promise<void> {
	if (TEXT_FILE.test(file.name)) return openText(studio, file);
	const refuse = (details: readonly string[], again?: () => void) =>
		studio.notify(text("open_failed"), details, { topic: FILE_TOPIC, ...(again ? { again } : {}) });
	const reader = await import("../../formats/restore").catch(() => undefined);
	if (!reader) {
		refuse(fetchFailed(), () => void openFile(studio, file));
		return;
	}
	try {
		const found = await reader.foundInFile(file.name, file);
		if ("library" in found) {
			await openPart(studio, SAVED);
			await document.querySelector<SavedDialog>(SAVED.tag)?.bring(file.name, found.library);
		} else if ("link" in found) {
			const { query, fragment } = linkParts(found.link);
			const model = await modelNamed(modelInQuery(query));
			studio.take(model, await decodeLink(model, query, fragment), FILE_TOPIC);
		} else {
			const model = await modelNamed(modelIn(found.record));
			studio.take(model, restore(model, found.record), FILE_TOPIC);
		}
	} catch (error) {
		const known = error instanceof reader.FileError;
		const drop = known ? dropsOf(studio).find(({ takes }) => takes(file)) : undefined;
		if (drop) drop.take(studio, file);
		else if (known)
			refuse([error.message, ...usesOfThisModel(studio, file), ...(await usesOfOtherModels(studio, file))]);
		else refuse([text("open_unreadable", { file: file.name })]);
	}
}

/** File names of grammars; the content decides the model. */
const TEXT_FILE = /\.(?:lsys|gl3|growth|stand|xml)$/i;

/** Opens a grammar's text in the model that it is written for. */
async function openText(studio: Studio, file: File): Promise<void> {
	const refuse = (why: string) => studio.notify(text("open_failed"), [why], { topic: FILE_TOPIC });
	const { name } = file;
	try {
		const long = fileLengthProblem(file.size, await file.slice(0, 64).text());
		if (long) return refuse(text("open_too_long", { file: name, problem: long.text }));
		const decoded = new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
		if (decoded.trim() === "") return refuse(text("open_empty", { file: name }));
		const { model, text: grammar, specimen } = await readText(decoded, name);
		// An XML file may be longer than the grammar in it: check the grammar's own length, too.
		const longText = textLengthProblem(grammar);
		if (longText) return refuse(text("open_grammar_too_long", { file: name, problem: longText.text }));
		if (model) studio.take(model, restore(model, { v: SPECIMEN_VERSION, grammar }, specimen), FILE_TOPIC);
	} catch (error) {
		if (error instanceof TextError) refuse(text("open_problem", { file: name, problem: error.message }));
		else if (error instanceof TypeError) refuse(text("open_not_text", { file: name }));
		else refuse(text("open_unreadable", { file: name }));
	}
}

/** Returns the files that the present model takes, for the message about a refused file. */
function usesOfThisModel(studio: Studio, { name }: File): string[] {
	// A GLB or JSON was meant to hold a specimen: other kinds do not matter.
	if (/\.(glb|json)$/i.test(name)) return [];
	const taken = dropsOf(studio).map(({ description }) => description);
	const { title } = studio.state.model;
	return [text("open_grammars"), ...taken.map((use) => text("open_with_model", { model: title, use }))];
}

/** Returns uses of the file by tools of other models: "Tree: a closed mesh (OBJ, GLB) becomes the boundary." */
async function usesOfOtherModels(studio: Studio, file: File): Promise<string[]> {
	const others = modelNames().filter((name) => name !== studio.state.model.name);
	const taken = others.map(async (name) => {
		const model = await modelNamed(name);
		const { tools } = (await model.ui?.()) ?? EMPTY_MODEL_UI;
		const drop = applying(tools, fromPreset(model)).find((tool) => tool.drop?.takes(file))?.drop;
		return drop && text("open_with_model", { model: model.title, use: drop.description });
	});
	const words = await Promise.all(taken.map((one) => one.catch(() => undefined)));
	return words.filter((one) => one !== undefined);
}
