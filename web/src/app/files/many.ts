/** Many plants of what is on the controls, as one archive: asked for in the words of the command line. */
import { independentDraws } from "../../batch/draws";
import { readPlantNumbers } from "../../batch/plant_numbers";
import { formatsOf as formatsOfSeries, type Series } from "../../batch/series";
import { type Watch, zipOf } from "../../batch/series_zip";
import { checkVaried, readVary } from "../../batch/vary";
import { Client } from "../../core/client";
import { coreAddress } from "../../core/core_address";
import { exportFile } from "../../generate/files/exporter";
import { CoreGrower } from "../core_grower";
import type { ShownPlant, StudioState } from "../studio_state";
import { type DownloadFormat, downloadFormats } from "./formats";

export interface Many {
	/** Numbers of the plants, as `--seeds` has them. */
	readonly numbers: string;
	/** As `--vary`; empty: only the seed. */
	readonly vary: string;
	/** The key of a kind of file. */
	readonly format: string;
}

/** Which files there can be of many: of those of the plant that is shown, what a series makes. */
export function formatsOfMany(shown: ShownPlant): readonly DownloadFormat[] {
	const made = formatsOfSeries(shown.model);
	return downloadFormats(shown, undefined).filter(({ key }) => made.includes(key));
}

/**
 * What is asked for, read.
 * @throws Unusable
 */
export function readMany(
	{ model, specimen }: StudioState,
	{ numbers, vary, format }: Many,
): { series: Series; numbers: number[] } {
	const varied = vary.trim() === "" ? [] : readVary(model, vary, specimen);
	const draws = independentDraws(model, specimen);
	return { series: { model, from: specimen, varied, draws, formats: [format] }, numbers: readPlantNumbers(numbers) };
}

/**
 * Grows them with a worker of their own, so that the page goes on.
 * @throws Unusable, the signal's reason, and what the workers say
 */
export async function growMany({ series, numbers }: ReturnType<typeof readMany>, watch: Watch): Promise<Blob> {
	await checkVaried(series.model, series.varied, series.from);
	const client = new Client();
	const cores = new CoreGrower(coreAddress, client);
	const { signal } = watch;
	try {
		const means = {
			grow: (model, specimen, options) => cores.grow(model, specimen, { ...options, signal }),
			make: (model, request) => exportFile(model, request, { signal }),
		} satisfies Parameters<typeof zipOf>[2];
		return await zipOf(series, numbers, means, watch);
	} finally {
		client.close();
	}
}
