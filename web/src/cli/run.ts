/** The command: grows one specimen and writes it. */
import { basename } from "node:path";
import { CoreError } from "../core/errors";
import { aboutPlant } from "../export/about_plant";
import { exportGlb } from "../export/glb";
import { exportJson } from "../export/json";
import { exportObj } from "../export/obj";
import type { Grown } from "../models/bunch/grown";
import { model } from "../models/bunch/index";
import { readGrown } from "../models/bunch/read_grown";
import { encodeRequest } from "../models/bunch/request";
import type { BunchSpecimen as Specimen } from "../models/bunch/specimen";
import { berriesCsv } from "../models/bunch/tables";
import { type Call, readArguments } from "./arguments";
import { askedSpecimen, reasonOf } from "./asked_specimen";
import type { Surroundings } from "./surroundings";
import { UsageError, usage } from "./usage";

/** @returns the exit status: 0 grown, 1 the core broke or is missing, 2 something in the call cannot be used */
export async function run(words: readonly string[], world: Surroundings): Promise<number> {
	try {
		const call = readArguments(words);
		if (call.help) world.print(usage());
		else await growAndWrite(call, world);
		return 0;
	} catch (error) {
		world.say(`grow: ${error instanceof Error ? error.message.replaceAll("\n", " ") : error}`);
		return error instanceof UsageError ? 2 : 1;
	}
}

async function growAndWrite(call: Call, world: Surroundings): Promise<void> {
	const { specimen, notes } = await askedSpecimen(call, world);
	const core = await world.loadCore();
	const meshes = call.out?.as === "glb" || call.out?.as === "obj";
	const grown = growing(grammarName(call, specimen), () => readGrown(core.grow(encodeRequest(specimen, { meshes }))));
	const all: Grown = { ...grown, notes: [...grown.notes, ...notes.map((note) => note.text)] };
	if (!call.out) {
		world.print(jsonOf(all, specimen));
		return;
	}
	for (const [file, data] of await filesOf(call.out, all, specimen)) {
		await world.writeFile(file, data).catch((error: unknown) => {
			throw new UsageError(`--out ${file}: ${reasonOf(error)}`);
		});
	}
	for (const note of all.notes) world.say(`note: ${note}`);
}

/** What messages call the grammar: its file; undefined for the built-in one. */
function grammarName({ grammarFile }: Call, { grammar }: Specimen): string | undefined {
	return grammarFile ?? (grammar === undefined ? undefined : "the link's grammar");
}

/** What the core refuses was asked for in the call; a place in the grammar is given as compilers do. */
function growing(grammar: string | undefined, grow: () => Grown): Grown {
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

async function filesOf(
	{ file, as }: NonNullable<Call["out"]>,
	grown: Grown,
	specimen: Specimen,
): Promise<[file: string, data: string | Uint8Array][]> {
	if (as === "json") return [[file, jsonOf(grown, specimen)]];
	if (as === "csv") return [[file, berriesCsv(grown, specimen)]];
	const [parts, about] = [model.parts(grown, specimen), await aboutPlant(model, grown, specimen)];
	if (as === "glb") return [[file, exportGlb(parts, about)]];
	const stem = file.slice(0, -".obj".length);
	const { obj, mtl } = exportObj(parts, about, basename(stem));
	return [
		[file, obj],
		[`${stem}.mtl`, mtl],
	];
}

function jsonOf(grown: Grown, specimen: Specimen): string {
	return `${JSON.stringify(exportJson(model, grown, specimen))}\n`;
}
