/** Makes files ahead while the download menu is open, one after the other: the menu shows their sizes, and has them when chosen. */
import { NotFetched } from "../../generate/files/exporter";
import { linkOf } from "../address";
import type { ShownPlant } from "../studio_state";
import type { DownloadFormat, DownloadRequest } from "./formats";

/** Cache key of a file: requests with the same key give the same file. */
const keyOf = ({ key }: DownloadFormat, { link, name, options }: DownloadRequest) =>
	JSON.stringify([key, link, name, options]);

export class MadeAhead {
	readonly #files = new Map<string, { grown: ShownPlant["grown"]; file: Blob }>();
	#work: AbortController | undefined;

	/** @param changed called after each file is made */
	constructor(readonly changed: () => void) {}

	/** Makes the files that are missing, slow ones last, until all are made or `stop` is called. Failed files are left out. */
	async start(formats: readonly DownloadFormat[], request: DownloadRequest): Promise<void> {
		this.stop();
		for (const [key, { grown }] of this.#files) if (grown !== request.plant.grown) this.#files.delete(key);
		const work = new AbortController();
		this.#work = work;
		const sized = formats.filter((format) => format.sized);
		for (const format of sized.toSorted((one, other) => Number(one.slow ?? false) - Number(other.slow ?? false))) {
			if (this.file(format, request)) continue;
			const file = await format.make(request, work.signal).catch((error: unknown) => error);
			// Without the script that makes files, the other files fail, too.
			if (work.signal.aborted || file instanceof NotFetched) return;
			if (file instanceof Blob) this.#files.set(keyOf(format, request), { grown: request.plant.grown, file });
			this.changed();
		}
	}

	/** Stops making files; finished files stay until `clear`. */
	stop(): void {
		this.#work?.abort();
	}

	clear(): void {
		this.stop();
		this.#files.clear();
	}

	/** The file, if it has been made from this plant. */
	file(format: DownloadFormat, request: DownloadRequest): Blob | undefined {
		const known = this.#files.get(keyOf(format, request));
		return known?.grown === request.plant.grown ? known.file : undefined;
	}
}

/** A request for files of a plant. */
export async function downloadRequestFor(
	plant: ShownPlant,
	name: string,
	options: DownloadRequest["options"],
): Promise<DownloadRequest> {
	return { plant, link: await linkOf(plant.model, plant.from), name, options };
}

/** A file size in decimal units: "2.9 MB", "41 kB". */
export function sizeInWords(bytes: number): string {
	if (bytes < 999_500) return `${Math.max(1, Math.round(bytes / 1000))} kB`;
	return `${(bytes / 1e6).toFixed(bytes < 9.95e6 ? 1 : 0)} MB`;
}
