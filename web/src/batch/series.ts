/** Many plants of one model that differ in seed and in what is varied: the same on any machine, in any order. */

import { PLANT_FILES } from "../export/plant_files";
import type { FileRequest } from "../files/messages";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import type { Aim } from "../targets/aim";
import { reachedInWords } from "../targets/words";
import { aimed } from "./aimed";
import { crc32 } from "./crc32";
import type { Draws } from "./draws";
import { Unusable } from "./unusable";
import { drawn, type Varied, withVaried } from "./vary";

export interface Series {
	readonly model: Model;
	/** What all plants have but for seed and what is varied. */
	readonly from: Specimen;
	readonly varied: readonly Varied[];
	/** Seeds and values of what is varied, by the plants' numbers. */
	readonly draws: Draws;
	/** Measures asked of each: its parameters are found for its seed. */
	readonly aims?: readonly Aim[];
	/** What files there are of each: a key of `formatsOf`. */
	readonly format: string;
}

/** One plant of a series, not yet grown. */
export interface Member {
	readonly number: number;
	readonly seed: number;
	readonly specimen: Specimen;
	/** The values of what is varied, in its order. */
	readonly values: readonly string[];
	/** Query and fragment that bring it back, by themselves. */
	readonly link: string;
	/** Its file's name. */
	readonly file: string;
}

export interface Grown {
	readonly plant: Plant;
	/** Query and fragment that bring it back; the member's own where nothing was asked of its measures. */
	readonly link: string;
	readonly bytes: Uint8Array<ArrayBuffer>;
	/** CRC-32 of the file. */
	readonly sum: string;
}

/** Every kind of file, by its key. */
export const formatsOf = ({ formats = [] }: Pick<Model, "formats">): string[] => [
	...[...PLANT_FILES.filter(({ life, levelled }) => !life && !levelled).map(({ key }) => key), "obj", "json"],
	...formats.map(({ key }) => key),
];

/** @throws Unusable where there is no such kind of file */
export function checkFormat(model: Model, format: string): void {
	const known = formatsOf(model);
	if (!known.includes(format))
		throw new Unusable(`“${format}” is no kind of file of a ${model.noun}; there are ${known.join(", ")}`);
}

/** What the name of a file ends in. */
function suffixOf({ formats }: Model, format: string): string {
	const own = formats?.find(({ key }) => key === format);
	if (own) return own.suffix;
	if (format === "obj") return "-obj.zip";
	const [kind, ...form] = format.split("-");
	return `${["", ...form].join("-")}.${kind}`;
}

/** What the file of a plant is called. */
export const fileOf = ({ model, from, format }: Series, number: number): string =>
	`${from.preset}-${number}${suffixOf(model, format)}`;

export async function memberOf(series: Series, number: number): Promise<Member> {
	const { model, from, varied, draws } = series;
	const seed = draws.seed(number);
	const values = varied.map((each) => drawn(each, number, draws));
	const seeded = restore(model, { seed }, from).specimen;
	const { specimen } = withVaried(
		model,
		seeded,
		varied.map((each, at) => [each, values[at]]),
	);
	const link = await encodeLink(model, specimen);
	return { number, seed, specimen, values, link, file: fileOf(series, number) };
}

export interface Means {
	grow(model: Model, specimen: Specimen, options: GrowthOptions): Promise<Plant>;
	make(model: Model, request: FileRequest): Promise<Blob>;
}

/** Grows one and makes its file; throws what these throw. */
export async function growMember(series: Series, asked: Member, means: Means): Promise<Grown> {
	const { model, format, aims = [] } = series;
	const { specimen, link, file, short } =
		aims.length > 0 ? await foundFor(series, asked, aims, means) : { ...asked, short: [] };
	const options = { meshes: format !== "json", measures: true };
	// How long it took is the machine's, and no part of what is the same everywhere.
	const plant = { ...(await means.grow(model, specimen, options)), timings: { grow: 0 } };
	const notes = [...plant.notes, ...short];
	const name = file.slice(0, -suffixOf(model, format).length);
	const request = { model: model.name, format, grown: plant, specimen, link, name };
	const blob = await means.make(model, request);
	const bytes = new Uint8Array(await blob.arrayBuffer());
	return { plant: { ...plant, notes }, link, bytes, sum: crc32(bytes) };
}

/** The member whose measures are what is asked, and what is to be said of those that are not. */
async function foundFor(
	{ model }: Series,
	member: Member,
	aims: readonly Aim[],
	{ grow }: Means,
): Promise<Member & { short: string[] }> {
	const { specimen, reached } = await aimed(model, member.specimen, aims, (each) =>
		grow(model, each, { meshes: false, measures: true }),
	);
	const short = reached.filter(({ there }) => !there).map((each) => `${reachedInWords(each)}.`);
	return { ...member, specimen, link: await encodeLink(model, specimen), short };
}
