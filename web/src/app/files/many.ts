/** Makes a batch of plants from the document on the controls, as one archive; with the command line's syntax. */
import { independentDraws } from "../../batch/draws";
import { readPlantNumbers } from "../../batch/plant_numbers";
import { formatKeysOf as formatsOfSeries, type Series } from "../../batch/series";
import { type Watch, zipOf } from "../../batch/series_zip";
import { checkVaried, readVary } from "../../batch/vary";
import { Client } from "../../core/client";
import { coreAddress } from "../../core/core_address";
import { exportFile } from "../../generate/files/exporter";
import { CoreGrower } from "../core_grower";
import type { ShownPlant, StudioState } from "../studio_state";
import { type DownloadFormat, downloadFormats } from "./formats";

export interface Many {
	/** Numbers of the plants, in the syntax of `--seeds`. */
	readonly numbers: string;
	/** Parameters to vary, in the syntax of `--vary`; empty: only the seed. */
	readonly vary: string;
	/** Key of the file format. */
	readonly format: string;
}

/** Formats available for a batch: those of the plant in view that a series can make. */
export function formatsOfMany(shown: ShownPlant): readonly DownloadFormat[] {
	const made = formatsOfSeries(shown.model);
	return downloadFormats(shown, undefined).filter(({ key }) => made.includes(key));
}

/**
 * Reads the fields of the batch dialog.
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
 * Grows the plants in a worker of their own, beside the page's.
 * @throws Unusable, the signal's reason, and errors of the workers
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
