/**
 * `npm run mutants`: makes each fault of the list in a copy of the checkout and runs the suites that ought to notice it
 * (docs/mutants.md). Results lie in build/mutants/results, one file a mutant, and hold until the fault's file or its tests
 * change; a run that is broken off goes on where it was.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { stripVTControlCharacters } from "node:util";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { withLock } from "../../wasm-core/tools/lock.mjs";
import { buildFolder } from "../../wasm-core/tools/repository.mjs";
import { Copy, RefusedError, readCheckout } from "./copy.mjs";
import { groups } from "./list/index.mjs";
import {
	applied,
	KINDS,
	keyOf,
	mutantsOf,
	parseArguments,
	problemsOf,
	repeatedIds,
	selected,
	sharded,
	suiteOf,
} from "./mutants.mjs";
import { complaints, ENOUGH, report, shareCaught } from "./report.mjs";
import { runSuites, syntaxError } from "./suites.mjs";

const place = join(buildFolder, "mutants");
const resultsFolder = join(place, "results");
const resultFile = (id) => join(resultsFolder, `${id}.json`);

/** Results that still hold. */
function storedResults(mutants) {
	const stored = new Map();
	for (const mutant of mutants) {
		if (!existsSync(resultFile(mutant.id))) continue;
		const result = JSON.parse(readFileSync(resultFile(mutant.id), "utf8"));
		if (result.key === keyOf(mutant, readCheckout)) stored.set(mutant.id, result);
	}
	return stored;
}

/** A suite that fails by itself would catch everything: all must pass without a fault first. */
async function proveSuites(copy, hash, mutants) {
	const file = join(copy.folder, ".passed.json");
	const known = existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : {};
	const passed = known.hash === hash ? known.passed : [];
	const suites = [...new Set(mutants.flatMap((mutant) => mutant.suites))].filter((suite) => !passed.includes(suite));
	for (const kind of KINDS) {
		const some = suites.filter((suite) => suiteOf(suite).kind === kind);
		if (some.length === 0) continue;
		console.log(`${some.length} suites of ${kind} without a fault …`);
		const { outcome, output } = await runSuites(copy.folder, some, { patient: true });
		if (outcome !== "passed") throw new Error(`They must pass first:\n${output.slice(-6000)}`);
		passed.push(...some);
		writeFileSync(file, JSON.stringify({ hash, passed }));
	}
}

/** @returns {Promise<Omit<import("./report.mjs").Result, "key" | "seconds">>} */
async function tried(copy, mutant) {
	const text = applied(copy.read(mutant.file) ?? "", mutant) ?? "";
	const wrong = await syntaxError(mutant.file, text);
	if (wrong) return { outcome: "invalid", why: stripVTControlCharacters(wrong).slice(0, 400) };
	try {
		copy.mutate(mutant.file, text);
	} catch (error) {
		if (!(error instanceof RefusedError)) throw error;
		return { outcome: "invalid", why: error.message.slice(0, 2000) };
	}
	for (const suite of mutant.suites) {
		const { outcome, output } = await runSuites(copy.folder, [suite]);
		if (outcome === "unbuilt") return { outcome: "invalid", why: output.slice(0, 2000) };
		if (outcome === "failed" || (outcome === "slow" && mutant.hangs)) return { outcome: "caught", by: suite };
		if (outcome === "slow") return { outcome: "slow" };
	}
	return { outcome: "survived" };
}

async function tryAll(copy, mutants, results) {
	for (const [i, mutant] of mutants.entries()) {
		const from = performance.now();
		const result = await tried(copy, mutant);
		const seconds = Math.round((performance.now() - from) / 100) / 10;
		const whole = { key: keyOf(mutant, copy.read), ...result, seconds };
		writeFileSync(resultFile(mutant.id), `${JSON.stringify(whole)}\n`);
		results.set(mutant.id, whole);
		const by = result.by ? ` by ${result.by}` : "";
		console.log(`${i + 1}/${mutants.length} ${mutant.id}: ${result.outcome}${by} (${seconds} s)`);
	}
}

async function main() {
	const wishes = parseArguments(process.argv.slice(2));
	if ("wrong" in wishes) throw new Error(wishes.wrong);
	const all = mutantsOf(groups);
	const mutants = sharded(selected(all, wishes.words), wishes.part, wishes.parts);
	const problems = [
		...repeatedIds(all).map((id) => `${id} is there twice`),
		...all.flatMap((m) => problemsOf(m, readCheckout)),
	];
	if (problems.length > 0) throw new Error(`The list is stale:\n${problems.join("\n")}`);
	mkdirSync(resultsFolder, { recursive: true });
	const results = wishes.again && !wishes.report ? new Map() : storedResults(mutants);
	const due = wishes.report ? [] : mutants.filter(({ id }) => !results.has(id));
	if (due.length > 0) {
		if (due.some(({ kind }) => kind !== "core")) await buildCore("wasm", ["all", "toy"]);
		const copy = new Copy(join(place, wishes.parts === 1 ? "copy" : `copy-${wishes.part}-${wishes.parts}`));
		await withLock(`${copy.folder}.lock`, async () => {
			const hash = copy.refresh();
			try {
				await proveSuites(copy, hash, due);
				await tryAll(copy, due, results);
			} finally {
				copy.restore();
			}
		});
	}
	console.log(`\n${report(mutants, results)}`);
	if (complaints(mutants, results).length > 0 || shareCaught(mutants, results) < ENOUGH) process.exitCode = 1;
}

try {
	await main();
} catch (error) {
	console.error(error instanceof Error ? error.message : error);
	process.exitCode = 1;
}
