/**
 * `npm run generate -- links [-- LINK…] [-- --renew]`: grows links and lists them with their fingerprints; without one, all that are to stand in the
 * list and do not. What is frozen is never changed; `--renew` takes what previews mean now.
 */
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const repository = fileURLToPath(new URL("../../../", import.meta.url));
const vitest = fileURLToPath(new URL("../../../node_modules/vitest/vitest.mjs", import.meta.url));
const { status } = spawnSync(process.execPath, [vitest, "run", "tests/golden/links/add.test.ts"], {
	cwd: repository,
	env: { ...process.env, PANICLE_ADD_LINKS: JSON.stringify(process.argv.slice(2)) },
	stdio: "inherit",
});
process.exit(status ?? 1);
