import { readdirSync, readFileSync } from "node:fs";
import { expect, it } from "vitest";

const FOLDER = "wasm-core/grammars";

/** `#define scale=1.98 /* 1.4 … 2.6, of the flower`, or with a blank in place of the sign. */
const RANGED = /^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t=]*(-?[\d.]+)[ \t]*\/\*[ \t]*(-?[\d.]+)[ \t]*…[ \t]*(-?[\d.]+)/gm;

it("every constant of the built-in texts lies in the range of its comment", () => {
	const files = readdirSync(FOLDER, { recursive: true, encoding: "utf8" }).filter((path) => !path.endsWith(".json"));
	const ranged = files.flatMap((path) => {
		if (!/\.\w+$/.test(path)) return [];
		return [...readFileSync(`${FOLDER}/${path}`, "utf8").matchAll(RANGED)].map(([, name, ...numbers]) => {
			const [value, low, high] = numbers.map(Number);
			return { what: `${path}: ${name}`, in: low <= value && value <= high };
		});
	});
	expect(ranged.length).toBeGreaterThan(100);
	expect(ranged.filter((each) => !each.in).map(({ what }) => what)).toEqual([]);
});
