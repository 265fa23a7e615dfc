/** The pages of the documentation with figures (wasm-core/tools/figures.mjs), and the values of these figures. */
import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { runnerImport } from "vite";
import { withFigures } from "../../wasm-core/tools/figures.mjs";
import { filesIn } from "../../wasm-core/tools/fresh.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { lastRelease } from "./check.mjs";
import { isOfCompiler } from "./compare.mjs";
import { compilerVersion, isAppBuilt, measure } from "./measure.mjs";

/** Counts below this are exact in pages; larger ones may differ by as much as sizes may. */
const EXACT = 1000;

/** Sizes of the built app and of the cores; none where the app is not built, and no core's where another compiler made it. */
function sizesOfBuild() {
	if (!isAppBuilt()) return {};
	const other = compilerVersion() !== lastRelease().emscripten;
	const rows = Object.entries(measure());
	const cores = rows.filter(([row]) => row.endsWith(".wasm")).reduce((sum, [, bytes]) => sum + bytes, 0);
	const offline = rows.find(([row]) => row === "offline app without cores")?.[1] ?? 0;
	return Object.fromEntries([
		...rows.filter(([row]) => !(other && isOfCompiler(row))),
		["offline app", cores + offline],
	]);
}

/**
 * The pages of the documentation with figures, and their figures brought up to date.
 * @param {{ sizes?: boolean }} [options] sizes: whether the sizes of the built files are measured
 * @returns {Promise<{ path: string, text: string }[]>}
 */
export async function pagesWithFigures({ sizes = true } = {}) {
	const { counts } = (await runnerImport(join(repository, "tests/sizes/counts.ts"))).module;
	const measured = sizes ? sizesOfBuild() : {};
	const figures = new Map([
		...Object.entries(counts).map(([name, value]) => [name, { value, exact: value < EXACT }]),
		...Object.entries(measured).map(([name, value]) => [name, { value }]),
	]);
	const known = new Set([...figures.keys(), ...Object.keys(lastRelease().sizes), "offline app"]);
	const inFolder = (folder) => filesIn(folder).map((file) => relative(repository, file));
	const files = [...readdirSync(repository), ...inFolder("docs")].filter((path) => path.endsWith(".md"));
	return files.flatMap((path) => {
		const page = readFileSync(join(repository, path), "utf8");
		if (!page.includes("<!-- figure: ")) return [];
		return [{ path, text: withFigures(page, figures, (name) => known.has(name)) }];
	});
}
