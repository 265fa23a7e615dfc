/**
 * `npm run package`: makes build/package/panicle-VERSION.tgz, the library for npm, and brings the pages of docs/api up to date. Prints the
 * tarball's path.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { makePackage } from "./package/make.mjs";
import { repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

await command(async () => {
	await setUp("core");
	const { tarball, pages } = await makePackage();
	const folder = join(repository, "docs/api");
	mkdirSync(folder, { recursive: true });
	for (const [name, text] of Object.entries(pages)) writeFileSync(join(folder, `${name}.md`), text);
	console.log(tarball);
});
