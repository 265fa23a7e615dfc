/**
 * What `npm test -- WORD …` runs. A word is a stage (`types`, `e2e`), a room (`lsystem`, `studio`, `core`), a model (`bunch`)
 * or a folder of tests (`models`, `toy`, `fuzz`): of all but stages, the tests that stand in folders of that name, in the core and
 * in the web.
 */
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { repository } from "../wasm-core/tools/repository.mjs";

/** Folders of tests that vitest runs, from the repository's root. */
const WEB = ["tests/web", "tests/web/models"];
const CORE = ["tests/core", "tests/core/models"];
/** Stages that look at what others have built. */
const BEFORE = { e2e: ["wasm core", "app"], browsers: ["wasm core", "app"] };
/** Folders beside those, whose tests vitest runs too. */
const BESIDE = ["docs", "fuzz", "golden", "package", "tools", "toy"];

const foldersIn = (place) =>
	existsSync(join(repository, place))
		? readdirSync(join(repository, place), { withFileTypes: true })
				.filter((entry) => entry.isDirectory() && entry.name !== "models")
				.map(({ name }) => name)
		: [];

/** Rooms, models and folders that have tests, without repetition, in the order of the alphabet. */
export function rooms() {
	const names = [...CORE, ...WEB].flatMap(foldersIn);
	const models = [CORE[1], WEB[1]].flatMap(foldersIn);
	const goldens = existsSync(join(repository, "tests/golden")) ? models : [];
	const beside = BESIDE.filter((folder) => existsSync(join(repository, "tests", folder)));
	return [...new Set(["core", "models", ...names, ...goldens, ...beside])].sort();
}

/**
 * @typedef {object} Selection
 * @property {string[]} stages names of the stages to run, in no order
 * @property {string[] | undefined} native programs of native tests; undefined: all of them in one
 * @property {string[]} web what vitest takes to choose files; empty: all
 */

/** The native programs of a room: `core` is every room. */
function nativeOf(word) {
	if (word === "core") return ["core_tests"];
	if (word === "models") return foldersIn(CORE[1]).map((model) => `${model}_tests`);
	return CORE.some((place) => foldersIn(place).includes(word)) ? [`${word}_tests`] : [];
}

function webOf(word) {
	if (word === "models") return [`${WEB[1]}/`, "tests/golden/"];
	if (BESIDE.includes(word)) return [`tests/${word}/`];
	const folders = WEB.filter((place) => foldersIn(place).includes(word)).map((place) => `${place}/${word}/`);
	const golden = `tests/golden/${word}.`;
	const goldens = existsSync(join(repository, `${golden}test.ts`)) ? [golden] : [];
	return [...folders, ...goldens];
}

/**
 * @param {readonly string[]} words
 * @param {readonly string[]} stages names of all stages
 * @returns {Selection | { unknown: string[] }}
 */
export function select(words, stages) {
	if (words.length === 0) return { stages: [...stages], native: undefined, web: [] };
	const known = rooms();
	const unknown = words.filter((word) => !stages.includes(word) && !known.includes(word));
	if (unknown.length > 0) return { unknown };
	const named = words.filter((word) => stages.includes(word));
	const before = named.flatMap((stage) => BEFORE[stage] ?? []);
	const parts = words.filter((word) => !stages.includes(word));
	const native = parts.flatMap(nativeOf);
	const web = parts.flatMap(webOf);
	const chosen = [...before, ...named];
	if (native.length > 0) chosen.push("native core");
	if (web.length > 0) chosen.push("web");
	return {
		stages: [...new Set(chosen)],
		native: native.length > 0 && !named.includes("native core") ? native : undefined,
		web: named.includes("web") ? [] : web,
	};
}
