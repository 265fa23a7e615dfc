/** `npm run bench -- proportion`: time and memory of every model, from its usual size to the largest that its ranges allow. */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { bundleForNode } from "../../wasm-core/tools/node_bundle.mjs";
import { buildFolder, modulesFolder } from "../../wasm-core/tools/repository.mjs";
import { printTable } from "./statistics.mjs";

/** The key of a link that sets a model's size, and its values from a usual one to the largest of its range. */
const SIZES = [
	{ model: "bunch", preset: "long-conical", key: "count", values: [120, 250, 500, 1000, 2000, 3000] },
	{ model: "leaf", preset: "oak", key: "n", values: [2000, 6000, 20_000] },
	{ model: "tree", preset: "oak", key: "n", values: [6000, 20_000, 60_000, 100_000] },
	{ model: "root", preset: "carrot", key: "n", values: [3000, 10_000, 30_000, 100_000] },
	{ model: "growth", preset: "oak", key: "steps", values: [6, 8, 10, 12, 14] },
	{ model: "flower", preset: "rose", key: "steps", values: [45, 60] },
	{ model: "grammar", preset: "row-of-trees", key: "steps", values: [4, 8, 16, 4096] },
	{ model: "stand", preset: "ecosystem-500", key: "many", values: [100, 500, 2000, 10_000] },
];

export async function benchProportion() {
	const { modelNamed, decodeQuery, loadCoreFromBytes } = await bundled();
	const rows = [["plant", "parts", "ms", "µs a part", "MB of the core", "end"]];
	for (const { model: name, preset, key, values } of SIZES) {
		const model = await modelNamed(name);
		for (const value of values) {
			const { specimen } = decodeQuery(model, `?v=2&model=${name}&preset=${preset}&${key}=${value}`);
			await model.prepare?.(specimen);
			const core = await loadCoreFromBytes(await readFile(join(modulesFolder, model.wasm)));
			const from = process.cpuUsage();
			let [parts, end] = [0, "whole"];
			try {
				const plant = model.read(core.grow(model.encode(specimen, { meshes: true, measures: true })), specimen);
				parts = plant.segments.count + plant.organs.count || plant.counts.plants || 0;
				if (plant.notes.some((note) => /limit/.test(note))) end = "limit";
			} catch (error) {
				end = error.message.slice(0, 60);
			}
			const { user, system } = process.cpuUsage(from);
			const microseconds = user + system;
			rows.push([
				`${name}/${preset}, ${key} ${value.toLocaleString("en")}`,
				parts.toLocaleString("en"),
				(microseconds / 1000).toFixed(0),
				parts > 0 ? (microseconds / parts).toFixed(1) : "",
				(core.memoryBytes / 1e6).toFixed(0),
				end,
			]);
		}
	}
	printTable("Every model from its usual size on: processor time and the memory of a fresh core", rows);
}

/** Models come by lazy imports, which a bundle resolves. */
async function bundled() {
	const folder = join(buildFolder, "node/bench-proportion");
	await bundleForNode({ models: "models/index.ts", link: "specimen/link.ts", loader: "core/loader.ts" }, folder);
	const at = (name) => import(pathToFileURL(join(folder, `${name}.mjs`)).href);
	return { ...(await at("models")), ...(await at("link")), ...(await at("loader")) };
}
