/** A series as one archive, byte for byte the folder that the command line writes. */
import { ZipStream } from "../generate/files/zip";
import { formatManifest, MANIFEST, manifestOf } from "./manifest";
import { text } from "./messages.generated";
import { growMember, memberOf, type Series, type SeriesMeans } from "./series";
import { columnsOf, failedRow, rowOf, written } from "./table";
import { Unusable } from "./unusable";

/** The most plants of one archive. */
export const MAX_IN_ARCHIVE = 1000;
/** The most bytes: some readers know no larger archives. */
const LARGEST = 2 ** 31;

export interface Watch {
	/** Cancels: the promise rejects with its reason. */
	signal: AbortSignal;
	/** Called after each plant with the number of finished ones. */
	progress(done: number): void;
}

/**
 * Grows plant after plant and packs their files with the table. A plant that cannot be grown has a row with the reason.
 * @throws Unusable where no plant can be grown, and where one archive is too small, and the signal's reason
 */
export async function zipOf(
	series: Series,
	numbers: readonly number[],
	means: SeriesMeans,
	watch: Watch,
): Promise<Blob> {
	const { signal, progress } = watch;
	if (numbers.length > MAX_IN_ARCHIVE) {
		throw new Unusable(text.message("archive_too_many", { max: MAX_IN_ARCHIVE, count: numbers.length }));
	}
	const archive = new ZipStream();
	const lines = [written(columnsOf(series))];
	let whole = 0;
	let why = "";
	for (const number of numbers) {
		signal.throwIfAborted();
		const member = await memberOf(series, number);
		try {
			const grown = await growMember(series, member, means);
			for (const { name, bytes } of grown.files) archive.add({ name, bytes });
			lines.push(written(rowOf(series, member, grown)));
			whole++;
		} catch (error) {
			signal.throwIfAborted();
			why = error instanceof Error ? error.message : String(error);
			lines.push(written(failedRow(series, member, why)));
		}
		if (archive.size > LARGEST) {
			throw new Unusable(text.message("archive_too_large", { count: lines.length - 1 }));
		}
		progress(lines.length - 1);
	}
	if (whole === 0) throw new Unusable(text.message("none_grown", { count: numbers.length, reason: why }));
	const encoder = new TextEncoder();
	archive.add({ name: "plants.csv", bytes: encoder.encode(lines.join("")) });
	archive.add({ name: MANIFEST, bytes: encoder.encode(formatManifest(manifestOf(series, numbers))) });
	return archive.end();
}
