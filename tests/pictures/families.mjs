/**
 * `npm run pictures -- families [FAMILY …]`: renders the plant that stands for each family on the home page, in both
 * themes with the app's own scene, as public/families/*.webp. Run it when such a preset or the light of the scene has
 * changed, and commit the files.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { drawPresets } from "./preset_pictures.mjs";

/** Twice the width at which most windows show them. */
const PICTURE = { size: { width: 560, height: 448 }, oversampling: 2, quality: 0.8, views: ["three-quarter"] };
/** How many times as large as in the whole view: a ground is wide, a root is narrow. */
const ZOOM = { gardens: 1.7, trees: 1.15, flowers: 1.25, grapes: 1.1, leaves: 1.1 };

const source = new URL("../../web/src/app/home/families.ts", import.meta.url);
const folder = new URL("../../public/families/", import.meta.url);

/** The plant of each family, read from the table of the home page. */
function plants() {
	const rows = readFileSync(source, "utf8").matchAll(/^\t(\w+): \{ model: "([\w-]+)", preset: "([\w-]+)" \}/gm);
	return [...rows].map(([, family, model, preset]) => ({ family, model, preset }));
}

/** @param {string[]} named families; none: all */
export async function render(named) {
	mkdirSync(folder, { recursive: true });
	for (const { family, model, preset } of plants()) {
		if (named.length > 0 && !named.includes(family)) continue;
		await drawPresets(
			model,
			["light", "dark"].map((theme) => ({ ...PICTURE, zoom: () => ZOOM[family], theme })),
			(_, { pictures }, { theme }) => {
				const bytes = pictures["three-quarter"];
				writeFileSync(new URL(`${family}-${theme}.webp`, folder), bytes);
				console.log(`public/families/${family}-${theme}.webp: ${(bytes.length / 1024).toFixed(0)} kB`);
			},
			({ name }) => name === preset,
		);
	}
}
