import { createHash } from "node:crypto";
import type { Columns } from "../../web/src/core/container";

/** Each column by its name: the width of a row, the number of rows, and a hash of the bytes. */
export function digest(columns: Columns): Record<string, string> {
	const entries = columns.names.sort().map((name) => {
		const data = columns.any(name);
		const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
		const hash = createHash("sha256").update(bytes).digest("hex").slice(0, 10);
		return [name, `${columns.width(name)} × ${data.length / columns.width(name)} ${hash}`];
	});
	return Object.fromEntries(entries);
}
