/**
 * `npm run test:long -- integrations`, or this script alone: the scripts of integrations/ with a game tree of the command
 * line, each in its program where that can be had – Blender (`bpy` from PyPI) and Godot (its engine for the web, from npm,
 * in Chromium) –, the others by compilers. Words name the programs to test: `node tests/integrations/run.mjs godot`.
 */
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildFolder } from "../../wasm-core/tools/repository.mjs";
import { inBlender } from "./blender.mjs";
import { checkUnity, checkUnreal } from "./compile.mjs";
import { growOak, writeSmallTree } from "./game_tree.mjs";
import { inGodot } from "./godot.mjs";

const folder = join(buildFolder, "integrations");

const PROGRAMS = {
	unity: () => checkUnity(folder),
	unreal: () => checkUnreal(),
	godot: async () => [
		...(await inGodot(writeSmallTree(folder), folder, "small")),
		...(await inGodot(await growOak(folder), folder, "oak")),
	],
	blender: async () => inBlender(await growOak(folder)),
};

/**
 * Runs the checks of some programs, and prints a line for each check.
 * @param {string[]} names
 * @returns {Promise<{ passed: number, failed: number }>}
 */
export async function testIntegrations(names = Object.keys(PROGRAMS)) {
	mkdirSync(folder, { recursive: true });
	const total = { passed: 0, failed: 0 };
	for (const name of names) {
		for (const { title, passed, found } of await PROGRAMS[name]()) {
			total[passed ? "passed" : "failed"]++;
			console.log(`${name}: ${title}: ${passed ? "ok" : `failed (${found})`}`);
		}
	}
	return total;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const names = process.argv.slice(2);
	const { failed } = await testIntegrations(names.length > 0 ? names : undefined);
	if (failed > 0) process.exitCode = 1;
}
