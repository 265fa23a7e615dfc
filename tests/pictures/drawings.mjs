/**
 * `npm run pictures -- drawings`: draws the SVGs of the documentation: floral diagrams and elevations of the designed
 * flowers, and veins of leaves with the measures in docs/models/leaf/likeness.md. Tests compare the files with newly
 * drawn ones.
 */
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { runnerImport } from "vite";
import { repository } from "../../wasm-core/tools/repository.mjs";

const source = async (name) => (await runnerImport(join(repository, "tests/pictures", name))).module;

export async function render() {
	const { diagrams } = await source("diagrams.ts");
	const { growLikeness } = await source("likeness.ts");
	for (const { path, text } of [...diagrams(), ...(await growLikeness()).files]) {
		writeFileSync(join(repository, path), text);
		console.log(path);
	}
}
