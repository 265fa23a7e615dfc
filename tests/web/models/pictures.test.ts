/** The gallery's pictures: every preset has one of each theme, and there are no others. */
import { existsSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import { modelNamed, modelNames } from "../../../web/src/models/index";

const GALLERY = fileURLToPath(new URL("../../../public/gallery/", import.meta.url));

it.each(modelNames())("%s: each preset has its pictures", async (name) => {
	const { presets, pictures } = await modelNamed(name);
	const named = presets.list.flatMap((preset) => ["dark", "light"].map((theme) => `${preset.name}-${theme}.webp`));
	const folder = `${GALLERY}${name}/`;
	const found = existsSync(folder) ? readdirSync(folder) : [];
	expect(found.sort()).toEqual(pictures === false ? [] : named.sort());
});
