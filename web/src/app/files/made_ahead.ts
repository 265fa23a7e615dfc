/**
 * Makes files ahead while the download sheet is open, one after the other: the sheet shows their sizes, and has them
 * when chosen.
 */
import { NotFetched } from "../../generate/files/exporter";
import { formatNumber } from "../../locale/format";
import { linkOf } from "../address";
import type { ShownPlant } from "../studio_state";
import type { DownloadFormat, DownloadRequest } from "./formats";

/** Returns the cache key of a file: requests with the same key give the same file. */
const keyOf = ({ key }: DownloadFormat, { link, name, options }: DownloadRequest) =>
	JSON.stringify([key, link, name, options]);

/** A file to be made, with its options. */
export interface FileToMake {
	readonly format: DownloadFormat;
	readonly request: DownloadRequest;
}

export class MadeAhead {
	/** Files, and errors of files that could not be made. */
	readonly #files = new Map<string, { grown: ShownPlant["grown"]; file: unknown }>();
	#work: AbortController | undefined;

	/** @param changed called after each file is made */
	constructor(readonly changed: () => void) {}

	/**
	 * Makes the files that are missing, slow ones last, until all are made or `stop` is called. Continues after a file
	 * that fails.
	 */
	async start(wanted: readonly FileToMake[]): Promise<void> {
		this.stop();
		const plants = new Set(wanted.map(({ request }) => request.plant.grown));
		for (const [key, { grown }] of this.#files) if (!plants.has(grown)) this.#files.delete(key);
		const work = new AbortController();
		this.#work = work;
		const isSlow = ({ format }: FileToMake) => Number(format.slow ?? false);
		const sized = wanted.filter(({ format }) => format.sized);
		for (const { format, request } of sized.toSorted((one, other) => isSlow(one) - isSlow(other))) {
			if (this.file(format, request)) continue;
			const file = await format.make(request, work.signal).catch((error: unknown) => error);
			// Without the script that makes files, the other files fail, too.
			if (work.signal.aborted || file instanceof NotFetched) return;
			this.#files.set(keyOf(format, request), { grown: request.plant.grown, file });
			this.changed();
		}
	}

	/** Stops making files; finished files stay until `clear`. */
	stop(): void {
		this.#work?.abort();
	}

	/** Stops making files and removes the finished ones. */
	clear(): void {
		this.stop();
		this.#files.clear();
	}

	/** Returns the file, if it has been made from this plant. */
	file(format: DownloadFormat, request: DownloadRequest): Blob | undefined {
		const made = this.#made(format, request);
		return made instanceof Blob ? made : undefined;
	}

	/**
	 * Returns the reason why the file could not be made from this plant; undefined if it was made, or is yet to be made.
	 */
	problem(format: DownloadFormat, request: DownloadRequest): string | undefined {
		const made = this.#made(format, request);
		if (made === undefined || made instanceof Blob) return undefined;
		return made instanceof Error ? made.message : String(made);
	}

	/** Returns the file or the error of a request; undefined if it was not made from this plant. */
	#made(format: DownloadFormat, request: DownloadRequest): unknown {
		const known = this.#files.get(keyOf(format, request));
		return known?.grown === request.plant.grown ? known.file : undefined;
	}
}

/** Returns a request for files of a plant. */
export async function downloadRequestFor(
	plant: ShownPlant,
	name: string,
	options: DownloadRequest["options"],
): Promise<DownloadRequest> {
	return { plant, link: await linkOf(plant.model, plant.from), name, options };
}

/** Describes a file size in decimal units: "2.9 MB", "41 kB". */
export function sizeInWords(bytes: number): string {
	const of = (value: number, unit: string, digits: number) =>
		formatNumber(value, { style: "unit", unit, minimumFractionDigits: digits, maximumFractionDigits: digits });
	if (bytes < 999_500) return of(Math.max(1, bytes / 1000), "kilobyte", 0);
	return of(bytes / 1e6, "megabyte", bytes < 9.95e6 ? 1 : 0);
}
