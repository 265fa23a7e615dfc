/**
 * `npm run generate`: writes the code and the pages of documentation that are made from tables and texts. With `--code` only code is
 * written, silently; with `--check` nothing is written and a file that is out of date is an error.
 */
import { fileURLToPath } from "node:url";
import { generate } from "./generate/files.mjs";

export { generate };

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const [check, code] = ["--check", "--code"].map((word) => process.argv.includes(word));
	const stale = generate({ write: !check, only: code ? "code" : undefined });
	if (check) for (const path of stale) console.error(`${path} is out of date: run \`npm run generate\`.`);
	else if (!code) for (const path of stale) console.error(`updated ${path}`);
	if (check && stale.length > 0) process.exitCode = 1;
}
