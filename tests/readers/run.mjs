/**
 * `npm run test:long -- readers`, or this script alone: files of each model, opened by independent programs – trimesh, Blender
 * (`bpy`), USD (`usd-core`) – and compared in counts and bounds. Installs these from PyPI into build/readers, which takes Python 3.11
 * with its venv and a gigabyte.
 */
import { statSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildFolder } from "../../wasm-core/tools/repository.mjs";
import { installed, must, readBy } from "./programs.mjs";

/** Blender's wheels are for this one alone. */
const PYTHON = "python3.11";
const folder = join(buildFolder, "readers");

/** Plants small enough to be read soon. */
const PLANTS = ["bunch/riesling", "leaf/oak", "root/carrot"];
/**
 * Files, their readers, and the largest difference of the bounds from those of the detailed file, as a share of the
 * longest edge. Blender removes one of two coincident triangles, as in the thinnest twigs: `fewer` is the permitted
 * share of missing ones. `most` is the largest size in bytes.
 */
const FILES = [
	{ name: "detailed.glb", words: ["--form", "detailed"], readers: ["trimesh", "blender"], within: 1e-5 },
	{
		name: "low.glb",
		words: ["--form", "low", "--triangles", "5000"],
		readers: ["trimesh", "blender"],
		within: 0.03,
		fewer: 0.01,
	},
	{ name: "plant.usdz", words: [], readers: ["usd", "blender"], within: 0.01 },
	{ name: "points.ply", words: ["--points", "20000"], readers: ["trimesh"], within: 0.05, count: 20000 },
	{ name: "print.stl", words: ["--thickness", "1"], readers: ["trimesh", "blender"], within: 0.03 },
	{ name: "print.3mf", words: ["--thickness", "1"], readers: ["trimesh"], within: 0.03 },
	{ name: "growth.glb", words: ["--form", "growth"], readers: ["trimesh"], within: 0.03, most: 6e6 },
];

/** How far boxes are apart, as a share of the second one's longest edge; prints may be to a scale. */
function apart(bounds, [low, high], scale) {
	const longest = Math.max(...high.map((value, k) => value - low[k]));
	const differences = [low, high].flatMap((corner, i) => corner.map((value, k) => bounds[i][k] * scale - value));
	return Math.max(...differences.map(Math.abs)) / longest;
}

function problems(found, { within, count, fewer = 0 }, first, detailed) {
	const longest = ([low, high]) => Math.max(...high.map((value, k) => value - low[k]));
	const ratio = longest(detailed.bounds) / longest(found.bounds);
	const scale = [1, 2, 5, 10, 20, 50, 100].find((each) => Math.abs(ratio / each - 1) < 0.1) ?? 1;
	const issues = [];
	if (apart(found.bounds, detailed.bounds, scale) > within) issues.push(`bounds ${JSON.stringify(found.bounds)}`);
	const wanted = count ?? first.count;
	if (found.count > wanted || found.count < (1 - fewer) * wanted) issues.push(`${found.count} in place of ${wanted}`);
	if (found.closed === false) issues.push("not closed");
	return [...issues, ...(found.complaints ?? [])];
}

/**
 * Reads every file of every plant with all its readers, and prints a line for each.
 * @returns {Promise<{ passed: number, failed: number }>} a check for each reader of a file
 */
export async function readFiles() {
	const python = await installed("readers", PYTHON);
	const total = { passed: 0, failed: 0 };
	for (const plant of PLANTS) {
		let detailed;
		for (const file of FILES) {
			const path = join(folder, `${plant.replace("/", "-")}-${file.name}`);
			await must(process.execPath, ["wasm-core/tools/grow.mjs", plant, "--out", path, ...file.words]);
			let first;
			for (const reader of file.readers) {
				const [found] = await readBy(python, reader, [path]);
				detailed ??= found;
				first ??= found;
				const issues = problems(found, file, first, detailed);
				if (statSync(path).size > (file.most ?? Number.POSITIVE_INFINITY)) issues.push(`more than ${file.most} bytes`);
				total[issues.length > 0 ? "failed" : "passed"]++;
				const size = (statSync(path).size / 1e6).toFixed(2);
				console.log(`${plant} ${file.name} ${size} MB, ${reader}: ${found.count} ${issues.join("; ") || "ok"}`);
			}
		}
	}
	console.log(total.failed === 0 ? "All readers agree." : `${total.failed} do not agree.`);
	return total;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const { failed } = await readFiles();
	if (failed > 0) process.exitCode = 1;
}
