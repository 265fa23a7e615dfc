/** Makes a batch of plants from the document on the controls, as one archive. */
import { independentDraws } from "../../batch/draws";
import { formatKeysOf as formatsOfSeries, type Series } from "../../batch/series";
import { type Watch, zipOf } from "../../batch/series_zip";
import { checkVaried, readVary } from "../../batch/vary";
import { Client } from "../../core/client";
import { coreAddress } from "../../core/core_address";
import { exportFile } from "../../generate/files/exporter";
import { CoreGrower } from "../core_grower";
import type { ShownPlant, StudioState } from "../studio_state";
import { type DownloadFormat, downloadFormats } from "./formats";

export interface BatchRequest {
	/** Number of the first plant; the others follow without gaps. */
	readonly first: number;
	/** The number of plants. */
	readonly count: number;
	/** Settings that vary, in the syntax of `--vary`; empty: only the seed varies. */
	readonly vary: string;
	/** Key of the file format. */
	readonly format: string;
}

/** Returns the formats available for a batch: those of the plant in view that a series can make. */
export function batchFormats(shown: ShownPlant): readonly DownloadFormat[] {
	const made = formatsOfSeries(shown.model);
	return downloadFormats(shown, undefined).filter(({ key }) => made.includes(key));
}

/**
 * Returns the series of a batch, and the numbers of its plants.
 * @throws Unusable
 */
export function seriesOf(
	{ model, specimen }: Pick<StudioState, "model" | "specimen">,
	{ first, count, vary, format }: BatchRequest,
): { series: Series; numbers: number[] } {
	const varied = vary === "" ? [] : readVary(model, vary, specimen);
	const draws = independentDraws(model, specimen);
	const numbers = Array.from({ length: count }, (_, at) => first + at);
	return { series: { model, from: specimen, varied, draws, formats: [format] }, numbers };
}

/** Returns the number of files in the archive: one for each plant, the table and the manifest. */
export const filesOf = ({ count }: Pick<BatchRequest, "count">): number => count + 2;

/**
 * Grows the plants in the background.
 * @throws Unusable, the signal's reason, and errors of the workers
 */
export async function growBatch({ series, numbers }: ReturnType<typeof seriesOf>, watch: Watch): Promise<Blob> {
	await checkVaried(series.model, series.varied, series.from);
	const client = new Client({ background: true });
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
