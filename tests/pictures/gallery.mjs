/**
 * `npm run pictures -- gallery [MODEL[/PRESET] …]`: renders the presets of the named models (default: all models) in both themes
 * with the app's own scene, as public/gallery/<model>/*.webp. `MODEL/PRESET` renders the presets whose names begin with PRESET.
 * Run it when a preset or the light of the scene has changed, and commit the files.
 */
import { mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { drawPresets } from "./preset_pictures.mjs";

/** Twice the size they are shown at, for dense screens. */
const PICTURE = { size: { width: 120, height: 150 }, oversampling: 4, quality: 0.86, views: ["three-quarter"] };
/** A ground is wide where pictures are tall: of a stand or a meadow its middle is shown. */
const ZOOM = { stand: 2.2, meadow: 2 };

/** Folders that hold an index.ts, in a family or by themselves. */
function everyModel() {
	return readdirSync(`${repository}/web/src/models`, { recursive: true })
		.map((path) => /(?:^|[/\\])([^/\\]+)[/\\]index\.ts$/.exec(path)?.[1])
		.filter((name) => name !== undefined);
}

/** @param {string[]} named models or presets; none: all */
export async function render(named) {
	for (const name of named.length > 0 ? named : everyModel()) {
		const [model, begin = ""] = name.split("/");
		const folder = new URL(`../../public/gallery/${model}/`, import.meta.url);
		mkdirSync(folder, { recursive: true });
		let total = 0;
		await drawPresets(
			model,
			["light", "dark"].map((theme) => ({ ...PICTURE, zoom: ({ name }) => ZOOM[model] ?? ZOOM[name], theme })),
			({ name }, { pictures }, { theme }) => {
				const bytes = pictures["three-quarter"];
				total += bytes.length;
				writeFileSync(new URL(`${name}-${theme}.webp`, folder), bytes);
			},
			({ name }) => name.startsWith(begin),
		);
		console.log(`public/gallery/${model}: ${(total / 1024).toFixed(0)} kB in all`);
	}
}
