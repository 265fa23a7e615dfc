/**
 * A bed of 300 flowers with grass: the time of its cores, and the number of plants that reuse an earlier plant's map.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { median, printTable } from "./statistics.mjs";

const PRESETS = ["flowerbed", "spring-border"];
const GRASS = "grass";
const RUNS = 3;

/** @param source fetches a module of the app by its path */
export async function benchBeds(source) {
	const { loadCoreFromBytes } = await source("web/src/core/loader.ts");
	const { model } = await source("web/src/models/stand/index.ts");
	const { growPlant } = await source("web/src/generate/growth.ts");
	const { fromPreset } = await source("web/src/specimen/from_preset.ts");
	const { textNames } = await source("tests/bench/flower_requests.ts");
	const rows = [];
	for (const preset of PRESETS) {
		const runs = [];
		for (let i = 0; i < RUNS; i++) {
			const core = new Map();
			const known = new Set();
			const plants = [];
			const run = async (wasm, blocks) => {
				if (!core.has(wasm))
					core.set(wasm, await loadCoreFromBytes(readFileSync(join(repository, "build/core", wasm))));
				const before = process.cpuUsage();
				const answer = core.get(wasm).grow(blocks);
				const { user, system } = process.cpuUsage(before);
				if (wasm !== model.wasm) plants.push(plantOf(known, textNames, blocks, answer, (user + system) / 1000));
				return answer;
			};
			await growPlant(model, fromPreset(model, preset), {}, run);
			runs.push({ plants, memory: [...core.values()].reduce((sum, each) => sum + each.memoryBytes, 0) });
		}
		const all = (part) =>
			median(runs.map(({ plants }) => plants.filter(part).reduce((sum, { time }) => sum + time, 0)));
		const { plants, memory } = runs[0];
		for (const [title, part] of [
			[`${preset}, flowers`, ({ name }) => name !== GRASS],
			["grass", ({ name }) => name === GRASS],
			...[...new Set(plants.map(({ name }) => name))].map((of) => [`– ${of}`, ({ name }) => name === of]),
		]) {
			const own = plants.filter(part);
			const mean = (k) => Math.round(own.reduce((sum, { triangles }) => sum + triangles[k], 0) / own.length);
			rows.push([
				title,
				own.length,
				all(part).toFixed(0),
				(all(part) / own.length).toFixed(2),
				`${Math.round((100 * own.filter(({ again }) => again).length) / own.length)} %`,
				...[0, 1, 2, 3].map(mean),
				(memory / 1e6).toFixed(0),
			]);
		}
	}
	printTable("stand: beds in wasm, one thread", [
		["", "plants", "all, ms", "a plant, ms", "placed anew", "level 0", "1", "2", "3", "MB"],
		...rows,
	]);
}

/** @returns the plant, and whether an earlier plant has the same triangles, so that its map was or could be reused */
function plantOf(known, textNames, blocks, { columns }, time) {
	const text = blocks.find(({ name }) => name === "text")?.data;
	const levels = [0, 1, 2, 3].map((k) => columns.uint32(`mesh.level${k}.indices`));
	const key = `${text}${levels[0].join()}`;
	const again = known.has(key);
	known.add(key);
	return {
		name: textNames.get(text) ?? "?",
		time,
		again,
		triangles: levels.map(({ length }) => length / 3),
	};
}
