/** A series as one archive: what the command line puts into a folder, byte for byte. */
import { ZipStream } from "../generate/files/zip";
import { formatManifest, MANIFEST, manifestOf } from "./manifest";
import { growMember, type Means, memberOf, type Series } from "./series";
import { columnsOf, failedRow, rowOf, written } from "./table";
import { Unusable } from "./unusable";

/** Plants of one archive at the most. */
export const MOST_IN_ARCHIVE = 1000;
/** Bytes of one: readers that know no larger ones count up to this. */
const LARGEST = 2 ** 31;

export interface Watch {
	/** Cancels: the promise rejects with its reason. */
	signal: AbortSignal;
	/** Told after each plant how many are done. */
	progress(done: number): void;
}

/**
 * Grows plant after plant and packs them with their table. One that cannot be grown has its line, which says why.
 * @throws Unusable where none can be grown, and where it comes to more than one archive holds, and the signal's reason
 */
export async function zipOf(series: Series, numbers: readonly number[], means: Means, watch: Watch): Promise<Blob> {
	const { signal, progress } = watch;
	if (numbers.length > MOST_IN_ARCHIVE) {
		throw new Unusable(
			`${numbers.length} plants; an archive holds at most ${MOST_IN_ARCHIVE}; the command line grows more`,
		);
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
			throw new Unusable(`after ${lines.length - 1} plants the archive is larger than 2 GB; ask for fewer`);
		}
		progress(lines.length - 1);
	}
	if (whole === 0) throw new Unusable(`none of the ${numbers.length} plants could be grown: ${why.replace(/\.$/, "")}`);
	const encoder = new TextEncoder();
	archive.add({ name: "plants.csv", bytes: encoder.encode(lines.join("")) });
	archive.add({ name: MANIFEST, bytes: encoder.encode(formatManifest(manifestOf(series, numbers))) });
	return archive.end();
}
