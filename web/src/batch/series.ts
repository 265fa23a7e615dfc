/**
 * A series: many plants of one model that differ in seed and varied parameters; the same on any machine, in any order.
 */

import { crc32Digits } from "../formats/crc32";
import type { FileOptions } from "../formats/file_options";
import { PLANT_FILES } from "../formats/plant_files";
import type { FileRequest } from "../generate/files/messages";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { reachedInWords } from "../targets/words";
import { aimed } from "./aimed";
import type { Draws } from "./draws";
import { aimsOf, type Goal } from "./goals";
import { text } from "./messages.generated";
import { Unusable } from "./unusable";
import { drawn, type Varied, withVaried } from "./vary";

export interface Series {
	readonly model: Model;
	/** The specimen of all plants, without seed and varied parameters. */
	readonly from: Specimen;
	readonly varied: readonly Varied[];
	/** Draws seeds and varied values by the plants' numbers. */
	readonly draws: Draws;
	/** Target measures of each plant: parameters are searched for with its seed. */
	readonly goals?: readonly Goal[];
	/** Kinds of files of each plant: keys of `formatKeysOf`, at least one. */
	readonly formats: readonly string[];
	readonly options?: FileOptions;
}

/** One plant of a series, not yet grown. */
export interface SeriesPlant {
	readonly number: number;
	readonly seed: number;
	readonly specimen: Specimen;
	/** The varied values, in the order of `varied`. */
	readonly values: readonly string[];
	/** The targets, in the order of the goals. */
	readonly aims: readonly Aim[];
	/** Query and fragment that restore the plant by itself. */
	readonly link: string;
	/** Names of its files, in the order of the formats. */
	readonly files: readonly string[];
}

/** A file of a plant. */
export interface MadeFile {
	readonly name: string;
	readonly bytes: Uint8Array<ArrayBuffer>;
	/** CRC-32 of the bytes. */
	readonly sum: string;
}

export interface GrownSeriesPlant {
	readonly plant: Plant;
	/** With the parameters that reach the targets, if there are targets. */
	readonly specimen: Specimen;
	/** Query and fragment that restore it; the member's own without targets. */
	readonly link: string;
	/** Keys of missed target measures. */
	readonly missed: readonly string[];
	/** In the order of the formats. */
	readonly files: readonly MadeFile[];
}

/** Returns the keys of all kinds of files. */
export const formatKeysOf = ({ formats = [] }: Pick<Model, "formats">): string[] => [
	...[...PLANT_FILES.filter(({ life, levelled }) => !life && !levelled).map(({ key }) => key), "obj", "json"],
	...formats.map(({ key }) => key),
];

/**
 * Checks that a model has a kind of file.
 * @throws Unusable
 */
export function checkFormat(model: Model, format: string): void {
	const known = formatKeysOf(model);
	if (!known.includes(format))
		throw new Unusable(text.message("format_unknown", { format, formats: known.join(", ") }));
}

/** Returns the suffix of a file's name: of `glb-low` it is `-low.glb`. */
function suffixOf({ formats }: Model, format: string): string {
	const own = formats?.find(({ key }) => key === format);
	if (own) return own.suffix;
	if (format === "obj") return "-obj.zip";
	const [kind, ...form] = format.split("-");
	return `${["", ...form].join("-")}.${kind}`;
}

/** Returns the names of a plant's files, in the order of the formats. */
export const fileNamesOf = ({ model, from, formats }: Series, number: number): string[] =>
	formats.map((format) => `${from.preset}-${number}${suffixOf(model, format)}`);

/**
 * Draws one plant of a series: its seed, the values of the varied parameters and its targets. The result depends on the
 * series and the number alone.
 * @param number the plant's number in the series
 */
export async function memberOf(series: Series, number: number): Promise<SeriesPlant> {
	const { model, from, varied, draws, goals = [] } = series;
	const seed = draws.seed(number);
	const values = varied.map((each) => drawn(each, number, draws));
	const seeded = restore(model, { seed }, from).specimen;
	const { specimen } = withVaried(
		model,
		seeded,
		varied.map((each, at) => [each, values[at]]),
	);
	const aims = aimsOf(model.table, goals, draws, number);
	const link = await encodeLink(model, specimen);
	return { number, seed, specimen, values, aims, link, files: fileNamesOf(series, number) };
}

export interface SeriesMeans {
	grow(model: Model, specimen: Specimen, options: GrowthOptions): Promise<Plant>;
	make(model: Model, request: FileRequest): Promise<Blob>;
}

/** Grows a plant and makes its files; rejects as these do. */
export async function growMember(series: Series, member: SeriesPlant, means: SeriesMeans): Promise<GrownSeriesPlant> {
	const { model, formats, options = {} } = series;
	const { specimen, link, missed } =
		member.aims.length > 0 ? await foundFor(series, member, means) : { ...member, missed: [] };
	const meshes = formats.some((format) => format !== "json");
	// The time of growing depends on the machine: leave it out.
	const plant = { ...(await means.grow(model, specimen, { meshes, measures: true })), timings: { grow: 0 } };
	const files: MadeFile[] = [];
	for (const [at, format] of formats.entries()) {
		const name = member.files[at];
		const stem = name.slice(0, -suffixOf(model, format).length);
		const request = { model: model.name, format, grown: plant, specimen, link, name: stem, options };
		const bytes = new Uint8Array(await (await means.make(model, request)).arrayBuffer());
		files.push({ name, bytes, sum: crc32Digits(bytes) });
	}
	const notes = [...plant.notes, ...missed.map(({ text }) => text)];
	return { plant: { ...plant, notes }, specimen, link, missed: missed.map(({ measure }) => measure), files };
}

interface Found {
	specimen: Specimen;
	link: string;
	/** The missed targets, with the nearest values in words. */
	missed: { measure: string; text: string }[];
}

/** Returns the specimen nearest to the targets. */
async function foundFor(
	{ model }: Series,
	{ specimen: from, aims }: SeriesPlant,
	{ grow }: SeriesMeans,
): Promise<Found> {
	const { specimen, reached } = await aimed(model, from, aims, (each) =>
		grow(model, each, { meshes: false, measures: true }),
	);
	const missed = reached
		.filter(({ isReached }) => !isReached)
		.map((each) => ({ measure: each.measure, text: `${reachedInWords(each)}.` }));
	return { specimen, link: await encodeLink(model, specimen), missed };
}
