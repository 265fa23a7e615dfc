/**
 * Runs a fuzz test for a number of cases: `npm run fuzz -- links [100000]`, or `npm run fuzz -- texts [100000]`, `--
 * growth` and `-- flower`, which run natively with the sanitizers. Texts that crash the engine are stored as
 * tests/fuzz/grammars/*.lsys.
 */
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";

/** The fuzz tests of a native program. */
async function native(program) {
	await buildCore("asan", [program]);
	return [join(buildFolder, "asan", program), "--source-file=*fuzz*_test.cpp"];
}

/** Programs and their arguments. */
const TESTS = {
	links: () => [process.execPath, "node_modules/vitest/vitest.mjs", "run", "tests/fuzz/any_link.test.ts"],
	texts: () => native("lsystem_tests"),
	growth: () => native("growth_tests"),
	flower: () => native("flower_tests"),
};

const [name = "links", runs = "100000"] = process.argv.slice(2);
if (!Object.hasOwn(TESTS, name) || !/^\d+$/.test(runs)) {
	console.error(`npm run fuzz -- ${Object.keys(TESTS).join("|")} [100000]`);
	process.exit(2);
}
const [command, ...args] = await TESTS[name]();
const seed = process.env.PANICLE_SEED ?? String(Math.floor(Math.random() * 2 ** 31));
console.log(`PANICLE_SEED=${seed} repeats this run.`);
const env = { ...process.env, PANICLE_FUZZ: runs, PANICLE_SEED: seed };
const { status } = spawnSync(command, args, { cwd: repository, env, stdio: "inherit" });
process.exit(status ?? 1);
