/** ZIP archives: of a few files, so that an OBJ and its MTL travel as one download, and of many, one after the other. */
import { Zip, ZipDeflate, ZipPassThrough, type Zippable, zipSync } from "fflate";
import { ZIP_DATE } from "../../formats/zip_date";

export interface ZipEntry {
	/** Without folders. */
	name: string;
	bytes: Uint8Array<ArrayBuffer>;
}

/** Higher levels make numbers written as text no smaller (16 MB of OBJ: 5.4 MB), and take two to three times as long. */
const LEVEL = 1;

/** The archive's bytes. */
export function zip(entries: readonly ZipEntry[]): Uint8Array<ArrayBuffer> {
	const files: Zippable = {};
	for (const { name, bytes } of entries) files[name] = bytes;
	return zipSync(files, { level: LEVEL, mtime: ZIP_DATE });
}

/** An archive that is written entry by entry; what is written is the browser's to keep, which need not be in memory. */
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

	/** What is an archive itself is not packed again. */
	add({ name, bytes }: ZipEntry): void {
		const entry = name.endsWith(".zip") ? new ZipPassThrough(name) : new ZipDeflate(name, { level: LEVEL });
		entry.mtime = ZIP_DATE;
		this.#zip.add(entry);
		entry.push(bytes, true);
	}

	end(): Blob {
		this.#zip.end();
		return new Blob(this.#chunks, { type: "application/zip" });
	}
}
