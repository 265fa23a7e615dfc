/** A ZIP archive of a few files, so that an OBJ and its MTL travel as one download. */
import { type Zippable, zipSync } from "fflate";

export interface ZipEntry {
	/** Without folders. */
	name: string;
	bytes: Uint8Array<ArrayBuffer>;
}

/** The earliest date the format knows, as clocks show it anywhere: the same bunch gives the same archive. */
const DATE = new Date(1980, 0, 1);
/** Higher levels make numbers written as text no smaller (16 MB of OBJ: 5.4 MB), and take two to three times as long. */
const LEVEL = 1;

/** The archive's bytes. */
export function zip(entries: readonly ZipEntry[]): Uint8Array<ArrayBuffer> {
	const files: Zippable = {};
	for (const { name, bytes } of entries) files[name] = bytes;
	return zipSync(files, { level: LEVEL, mtime: DATE });
}
