/** Options of files (`--points 5000`): refused where no file uses them, since ignoring them would spoil a series. */
import type { FileOptions } from "../formats/file_options";
import { PLANT_FILES } from "../formats/plant_files";
import { formatList } from "../locale/format";
import { text } from "./messages.generated";
import { optionError } from "./usage";

/**
 * Refuses options that none of the files to make uses.
 * @param formats keys of the kinds of files to make
 * @throws UsageError
 */
export function refuseUnused(options: FileOptions, formats: readonly string[]): void {
	for (const option of Object.keys(options) as (keyof FileOptions)[]) {
		const users = PLANT_FILES.filter(({ uses = [] }) => uses.includes(option)).map(({ key }) => key);
		if (formats.some((format) => users.includes(format))) continue;
		const named = { users: formatList(users), files: formatList(formats) };
		throw optionError(
			`--${option.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`,
			text.message("option_unused", named),
		);
	}
}
