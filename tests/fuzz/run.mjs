/** `npm run fuzz -- links [100000]`: the longer run of a fuzz test, by the number of its cases. */
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const TESTS = { links: "tests/fuzz/any_link.test.ts" };

const [name = "links", runs = "100000"] = process.argv.slice(2);
if (!Object.hasOwn(TESTS, name) || !/^\d+$/.test(runs)) {
	console.error(`npm run fuzz -- ${Object.keys(TESTS).join("|")} [100000]`);
	process.exit(2);
}
const vitest = fileURLToPath(new URL("../../node_modules/vitest/vitest.mjs", import.meta.url));
const { status } = spawnSync(process.execPath, [vitest, "run", TESTS[name]], {
	cwd: fileURLToPath(new URL("../../", import.meta.url)),
	env: { ...process.env, PANICLE_FUZZ: runs },
	stdio: "inherit",
});
process.exit(status ?? 1);
