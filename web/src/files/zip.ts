/** A ZIP archive of a few files, so that an OBJ and its MTL travel as one download. */
import { type Zippable, zipSync } from "fflate";
import { ZIP_DATE } from "../export/zip_date";

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
