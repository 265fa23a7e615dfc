/** The gallery's pictures: every preset has one of each theme, and there are no others. */
import { existsSync, readdirSync, statSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import { modelNamed, modelNames } from "../../../web/src/models/index";

const GALLERY = fileURLToPath(new URL("../../../public/gallery/", import.meta.url));
/** Bytes of a picture, at the most: the strip shows hundreds. */
const LARGEST = 8192;

it.each(modelNames())("%s: each preset has its pictures, small ones", async (name) => {
	const { presets, pictures } = await modelNamed(name);
	const named = presets.list.flatMap((preset) => ["dark", "light"].map((theme) => `${preset.name}-${theme}.webp`));
	const folder = `${GALLERY}${name}/`;
	const found = existsSync(folder) ? readdirSync(folder) : [];
	expect(found.sort()).toEqual(pictures === false ? [] : named.sort());
	for (const file of found) expect(statSync(folder + file).size, file).toBeLessThan(LARGEST);
});
