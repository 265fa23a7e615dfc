/** Files made while the menu is open, one after the other: so it says how large each is, and has it when it is chosen. */
import { NotFetched } from "../../generate/files/exporter";
import { linkOf } from "../address";
import type { ShownPlant } from "../studio_state";
import type { DownloadFormat, DownloadRequest } from "./formats";

/** What a format isActive of what was asked for: two askings that agree in it give the same file. */
const keyOf = ({ key }: DownloadFormat, { link, name, options }: DownloadRequest) =>
	JSON.stringify([key, link, name, options]);

export class MadeAhead {
	readonly #files = new Map<string, { grown: ShownPlant["grown"]; file: Blob }>();
	#work: AbortController | undefined;

	/** @param changed called when a file is there */
	constructor(readonly changed: () => void) {}

	/** Makes what of `formats` is not there yet, the slow ones last, until all are or `stop` is called. What fails is left out. */
	async start(formats: readonly DownloadFormat[], request: DownloadRequest): Promise<void> {
		this.stop();
		for (const [key, { grown }] of this.#files) if (grown !== request.plant.grown) this.#files.delete(key);
		const work = new AbortController();
		this.#work = work;
		const sized = formats.filter((format) => format.sized);
		for (const format of sized.toSorted((one, other) => Number(one.slow ?? false) - Number(other.slow ?? false))) {
			if (this.file(format, request)) continue;
			const file = await format.make(request, work.signal).catch((error: unknown) => error);
			// Where the script that makes them does not come, it does not come for the next either.
			if (work.signal.aborted || file instanceof NotFetched) return;
			if (file instanceof Blob) this.#files.set(keyOf(format, request), { grown: request.plant.grown, file });
			this.changed();
		}
	}

	/** Ends the making; what there is stays until `clear`. */
	stop(): void {
		this.#work?.abort();
	}

	clear(): void {
		this.stop();
		this.#files.clear();
	}

	/** The file, where it has been made of that very plant. */
	file(format: DownloadFormat, request: DownloadRequest): Blob | undefined {
		const known = this.#files.get(keyOf(format, request));
		return known?.grown === request.plant.grown ? known.file : undefined;
	}
}

/** What a plant is to be made into a file as. */
export async function downloadRequestFor(
	plant: ShownPlant,
	name: string,
	options: DownloadRequest["options"],
): Promise<DownloadRequest> {
	return { plant, link: await linkOf(plant.model, plant.from), name, options };
}

/** "2.9 MB", "41 kB": as downloads are counted, in thousands. */
export function sizeInWords(bytes: number): string {
	if (bytes < 999_500) return `${Math.max(1, Math.round(bytes / 1000))} kB`;
	return `${(bytes / 1e6).toFixed(bytes < 9.95e6 ? 1 : 0)} MB`;
}
