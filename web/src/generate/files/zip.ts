/**
 * ZIP archives: of a few files, so that an OBJ and its MTL are one download, and of many, written one after the other.
 */
import { Zip, ZipDeflate, ZipPassThrough, type Zippable, zipSync } from "fflate";
import { ZIP_DATE } from "../../formats/zip_date";

export interface ZipEntry {
	/** File name without folders. */
	name: string;
	bytes: Uint8Array<ArrayBuffer>;
}

/**
 * Compression level: higher ones make numbers in text no smaller (16 MB of OBJ: 5.4 MB), and take two to three times as
 * long.
 */
const LEVEL = 1;

/** Returns the archive of all entries, as bytes. */
export function zip(entries: readonly ZipEntry[]): Uint8Array<ArrayBuffer> {
	const files: Zippable = {};
	for (const { name, bytes } of entries) files[name] = bytes;
	return zipSync(files, { level: LEVEL, mtime: ZIP_DATE });
}

/** An archive that is written entry by entry into a blob, which the browser need not hold in memory. */
export class ZipStream {
	readonly #chunks: Blob[] = [];
	readonly #zip = new Zip((error, chunk) => {
		if (error) throw error;
		this.#size += chunk.length;
		this.#chunks.push(new Blob([chunk as Uint8Array<ArrayBuffer>]));
	});
	#size = 0;

	/** Bytes written so far. */
	get size(): number {
		return this.#size;
	}

	/** Adds an entry; archives are stored without compressing them again. */
	add({ name, bytes }: ZipEntry): void {
		const entry = name.endsWith(".zip") ? new ZipPassThrough(name) : new ZipDeflate(name, { level: LEVEL });
		entry.mtime = ZIP_DATE;
		this.#zip.add(entry);
		entry.push(bytes, true);
	}

	/** Ends the archive and returns it. */
	end(): Blob {
		this.#zip.end();
		return new Blob(this.#chunks, { type: "application/zip" });
	}
}
