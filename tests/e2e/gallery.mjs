/**
 * `npm run gallery`: renders every preset in both themes with the app's own scene, as public/gallery/<model>/*.webp. Run it when
 * a preset or the scene's light has changed, and commit what it writes.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { drawPresets } from "./preset_pictures.mjs";

const folder = new URL("../../public/gallery/bunch/", import.meta.url);
/** Twice the size they are shown at, for dense screens. */
const PICTURE = { size: { width: 120, height: 150 }, oversampling: 4, quality: 0.86, views: ["three-quarter"] };

mkdirSync(folder, { recursive: true });
let total = 0;
await drawPresets(
	["light", "dark"].map((theme) => ({ ...PICTURE, theme })),
	({ name }, { pictures }, { theme }) => {
		const bytes = pictures["three-quarter"];
		total += bytes.length;
		writeFileSync(new URL(`${name}-${theme}.webp`, folder), bytes);
	},
);
console.log(`public/gallery: ${(total / 1024).toFixed(0)} kB in all`);
