import { mkdirSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { expect } from "@playwright/test";
import { sizeLimit } from "./check.mjs";
import { buildId, measuredFile } from "./measure.mjs";

/**
 * Checks a size that only a browser can measure: it may be 2 % over the last release's (last_release.json). Leaves the size for the table of
 * check.mjs. While the sizes of a release are recorded (`PANICLE_SIZES=record`) every size is accepted.
 */
export function expectSize(row: string, bytes: number): void {
	const file = measuredFile(row);
	mkdirSync(dirname(file), { recursive: true });
	writeFileSync(file, JSON.stringify({ row, bytes, build: buildId() }));
	if (process.env.PANICLE_SIZES === "record") return;
	const limit = sizeLimit(row);
	if (limit === undefined) throw new Error(`${row} is not in last_release.json; add it by npm run release -- --sizes`);
	expect(bytes, `${row}: more than 2 % over the last release; see tests/sizes/check.mjs`).toBeLessThanOrEqual(limit);
}
