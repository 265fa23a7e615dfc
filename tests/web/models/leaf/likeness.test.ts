/**
 * The measures and the drawing in docs/models/leaf/likeness.md match the grown leaves, and the measures are within the
 * ranges of real leaves. `npm run pictures -- drawings` writes both.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { beforeAll, describe, expect, it } from "vitest";
import { repository } from "../../../../wasm-core/tools/repository.mjs";
import { committedRows, growLikeness } from "../../../pictures/likeness";

const rows = committedRows();
let grown: Awaited<ReturnType<typeof growLikeness>>;
beforeAll(async () => {
	grown = await growLikeness();
});

describe("the page of likenesses", () => {
	it("has four leaves, each with lengths per area, angles and spacings", () => {
		expect(new Set(rows.map(({ preset }) => preset)).size).toBe(4);
		expect(rows.length).toBeGreaterThanOrEqual(28);
		for (const order of ["1°", "2°", "3°"])
			expect(rows.filter(({ measure }) => measure.startsWith(`${order} length`))).toHaveLength(4);
		expect(rows.filter(({ range }) => range).length).toBeGreaterThanOrEqual(20);
	});

	it.each(rows)("$preset: $measure is that of the leaf that grows", (row) => {
		expect(row.ours).toBe(grown.measured(row));
	});

	it.each(rows.filter(({ range }) => range))("$preset: $measure is within the range of real leaves", (row) => {
		const [least, most] = row.range as [number, number];
		expect(Number(grown.measured(row))).toBeGreaterThanOrEqual(least);
		expect(Number(grown.measured(row))).toBeLessThanOrEqual(most);
	});

	it("and its drawing are the files that `npm run pictures -- drawings` writes", () => {
		for (const { path, text } of grown.files)
			expect(readFileSync(join(repository, path), "utf8") === text, path).toBe(true);
	});
});
