/**
 * Reads the arguments of a test run. A word is a stage (`types`, `e2e`), a room (`lsystem`, `studio`, `core`), a model
 * (`bunch`), a folder of tests (`models`, `toy`, `fuzz`), or `unit`: native and web tests. `--long` chooses the long run,
 * `--changed` the tests of changed files.
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { changeBase, changedFiles } from "../../wasm-core/tools/changes.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { foldersIn, isOfCore } from "./changed.mjs";

/** Folders of vitest's tests by room, from the repository's root. */
const WEB = ["tests/web", "tests/web/models"];
const CORE = ["tests/core", "tests/core/models"];
/** Other folders of vitest's tests. */
const OTHER = ["docs", "fuzz", "golden", "language", "package", "tools", "toy"];
/** Tests of every model: a model's name chooses them too. */
const OF_ALL_MODELS = "tests/golden/native_wasm.test.ts";
/** Stages that need the results of others. */
const NEEDS = {
	e2e: ["wasm", "app"],
	sizes: ["wasm", "app"],
	browsers: ["wasm", "app"],
	web: ["wasm"],
	app: ["wasm"],
	soak: ["wasm", "app"],
};
/** Words that stand for several stages. */
const GROUPS = { unit: ["native", "wasm", "web"] };
/** Stages that take seconds: they run after any change. */
const QUICK = ["docs", "lint", "types"];

/**
 * @typedef {object} Plan
 * @property {boolean} isLong
 * @property {string[]} stages names of the stages to run
 * @property {string[]} native programs of native tests
 * @property {string[]} web arguments by which vitest chooses files; empty: all
 * @property {string[]} endToEnd arguments by which Playwright chooses files; empty: all
 */

/** Folders of tests in a folder; that of the models holds one folder a model. */
const testsIn = (place) => foldersIn(place).filter((name) => name !== "models");

/** Rooms, models and folders that have tests, each once, in alphabetical order. */
export function rooms() {
	const names = [...CORE, ...WEB].flatMap(testsIn);
	const other = OTHER.filter((folder) => existsSync(join(repository, "tests", folder)));
	return [...new Set(["core", "models", ...names, ...other])].sort();
}

/** The native programs of a room or model; `core` is every room. */
function nativeOf(word) {
	if (word === "core") return ["core_tests"];
	if (word === "models") return testsIn(CORE[1]).map((model) => `${model}_tests`);
	return CORE.some((place) => testsIn(place).includes(word)) ? [`${word}_tests`] : [];
}

function webOf(word) {
	if (word === "models") return [`${WEB[1]}/`, "tests/golden/"];
	if (OTHER.includes(word)) return [`tests/${word}/`];
	const folders = WEB.filter((place) => testsIn(place).includes(word)).map((place) => `${place}/${word}/`);
	return testsIn(WEB[1]).includes(word) ? [...folders, OF_ALL_MODELS] : folders;
}

/** The stages named, with those that they need, in the order of all stages; the set-up always comes first. */
function ordered(stages, names) {
	const withNeeds = names.flatMap((name) => [...(NEEDS[name] ?? []), name]);
	return stages.map(({ name }) => name).filter((name) => name === "set-up" || withNeeds.includes(name));
}

/**
 * The tests of changed files. Where it is the core, all native and web tests, since every model grows by it; else the web
 * tests that import a changed file.
 */
function changedPlan(stages, isLong, files) {
	if (files?.length === 0)
		return { nothing: "Nothing has changed since this branch left main: there is nothing to test." };
	const isCore = !files || files.some(isOfCore);
	const base = isCore ? undefined : changeBase();
	const isTest = (file) => /^tests\/e2e\/.*\.spec\.ts$/.test(file) && existsSync(join(repository, file));
	const endToEnd = (files ?? []).filter(isTest);
	const names = [...QUICK, "web"];
	if (isCore) names.push("native");
	if (endToEnd.length > 0) names.push("e2e");
	const native = isCore ? ["core_tests"] : [];
	return { isLong, stages: ordered(stages, names), native, web: base ? [`--changed=${base}`] : [], endToEnd };
}

/**
 * @param {readonly string[]} args
 * @param {readonly { name: string, isLong?: boolean }[]} stages
 * @returns {Plan | { problem: string } | { nothing: string }} problem: wrong arguments; nothing: why there is nothing to test
 */
export function readArguments(args, stages, changed = changedFiles) {
	const isLong = args.includes("--long");
	const flags = args.filter((arg) => arg.startsWith("-"));
	const wrong = flags.find((flag) => !["--long", "--changed"].includes(flag));
	if (wrong) return { problem: `Unknown option ${wrong}; there are --long and --changed.` };
	const words = args.filter((arg) => !arg.startsWith("-")).flatMap((word) => GROUPS[word] ?? [word]);
	if (flags.includes("--changed")) {
		if (words.length > 0) return { problem: "--changed chooses the tests by itself: leave out the words." };
		return changedPlan(stages, isLong, changed());
	}
	const all = { isLong, native: ["core_tests"], web: [], endToEnd: [] };
	if (words.length === 0)
		return { ...all, stages: stages.filter((stage) => isLong || !stage.isLong).map(({ name }) => name) };
	const names = stages.map(({ name }) => name);
	const unknown = words.filter((word) => !names.includes(word) && !rooms().includes(word));
	if (unknown.length > 0) {
		const known = [...new Set([...names, ...Object.keys(GROUPS), ...rooms()])].join(", ");
		return { problem: `No stage, room or model “${unknown.join("”, “")}”; there are: ${known}.` };
	}
	const chosen = words.filter((word) => names.includes(word));
	// `app` is both a stage and a room: its word chooses both.
	const parts = words.filter((word) => rooms().includes(word));
	const native = [...new Set(parts.flatMap(nativeOf))];
	const web = [...new Set(parts.flatMap(webOf))];
	if (native.length > 0 && !chosen.includes("native")) chosen.push("native");
	if (web.length > 0 && !chosen.includes("web")) chosen.push("web");
	return {
		...all,
		stages: ordered(stages, chosen),
		native: words.includes("native") || native.length === 0 ? ["core_tests"] : native,
		web: words.includes("web") ? [] : web,
	};
}
