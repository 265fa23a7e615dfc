/** The command: grows one specimen of any model and writes it. */
import { CoreError } from "../core/errors";
import { FORMS, plantFile } from "../export/plant_files";
import { agedOf, hasAges } from "../files/aged";
import { modelNamed, modelNames } from "../models/index";
import type { Plant } from "../plant/plant";
import { type Call, readArguments } from "./arguments";
import { askedModel, askedSpecimen, reasonOf } from "./asked_specimen";
import { endingOf, endingsOf, filesOf, jsonOf } from "./outputs";
import { growSeries } from "./series";
import type { Surroundings } from "./surroundings";
import { UsageError, usage } from "./usage";

/** @returns the exit status: 0 grown, 1 the core broke or is missing or some of a series did not grow, 2 something in the call cannot be used */
export async function run(words: readonly string[], world: Surroundings): Promise<number> {
	try {
		const call = readArguments(words);
		if (call.help) world.print(usage(await askedModel(call.source), modelNames()));
		else if (call.list) world.print(await listed());
		else if (call.batch) return await growSeries(call, call.batch, world);
		else await growAndWrite(call, world);
		return 0;
	} catch (error) {
		world.say(`grow: ${error instanceof Error ? error.message.replaceAll("\n", " ") : error}`);
		return error instanceof UsageError ? 2 : 1;
	}
}

/** Every model with its title and the names of its presets, as JSON. */
async function listed(): Promise<string> {
	const models = await Promise.all(modelNames().map(modelNamed));
	const rows = models.map(({ name, title, presets }) => ({
		model: name,
		title,
		presets: presets.list.map((preset) => preset.name),
	}));
	return `${JSON.stringify(rows)}\n`;
}

async function growAndWrite(call: Call, world: Surroundings): Promise<void> {
	const { model, specimen, notes } = await askedSpecimen(call, world);
	const { out } = call;
	const ending = out === undefined ? "json" : endingOf(model, out);
	if (out?.toLowerCase().endsWith(".png"))
		throw new UsageError(`--out ${out}: pictures take a graphics card; take them in the page, from its Download menu`);
	if (ending === undefined) throw new UsageError(`--out ${out}: the name must end in ${endingsOf(model)}`);
	checkForm(call, ending, hasAges(model, specimen));
	const core = await world.loadCore(model.wasm);
	// What a file does not say is not worked out for it.
	const json = ending === "json";
	const [meshes, measures] = [!json, json || plantFile(ending)?.form !== undefined];
	await model.prepare?.(specimen);
	const text = "grammar" in specimen ? "the link's grammar" : undefined;
	const grown = growing(call.grammarFile ?? text, () =>
		model.read(core.grow(model.encode(specimen, { meshes, measures })), specimen),
	);
	const all: Plant = { ...grown, notes: [...grown.notes, ...notes.map((note) => note.text)] };
	if (out === undefined) {
		world.print(jsonOf(model, all, specimen));
		return;
	}
	const aged = agedOf(model, specimen, async (younger) =>
		model.read(core.grow(model.encode(younger, { measures: false })), younger),
	);
	const options = { ...call.files, form: call.form };
	for (const [file, data] of await filesOf(out, ending, model, all, specimen, options, aged)) {
		await world.writeFile(file, data).catch((error: unknown) => {
			throw new UsageError(`--out ${file}: ${reasonOf(error)}`);
		});
	}
	for (const note of all.notes) world.say(`note: ${note}`);
}

/** @throws UsageError where there is no such form of the file, or the plant has no ages for it to show */
function checkForm({ form, out }: Call, ending: string, ages: boolean): void {
	const file = plantFile(ending, form);
	if (file?.life && !ages) throw new UsageError(`--form ${form}: this plant has no ages to show`);
	if (form === undefined || file) return;
	const known = out !== undefined && plantFile(ending)?.form !== undefined;
	const say = known ? `the forms are ${FORMS.join(", ")}` : "only a .glb has forms; see --help";
	throw new UsageError(`--form ${form}: ${say}`);
}

/**
 * What the core refuses was asked for in the call; a place in the grammar is given as compilers do.
 * @param grammar what messages call the grammar: its file; undefined for the built-in one
 */
function growing(grammar: string | undefined, grow: () => Plant): Plant {
	try {
		return grow();
	} catch (error) {
		if (!(error instanceof CoreError)) throw error;
		const { reason, line, column, message } = error;
		const ofGrammar = grammar !== undefined && reason !== "bad request" && reason !== "bad input";
		const place = line > 0 ? `:${line}:${column}` : "";
		throw new UsageError(ofGrammar ? `${grammar}${place}: ${message}` : message);
	}
}
