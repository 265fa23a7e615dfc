/** The bark of the species: each wears the kind that its preset names. */
import { expect, it } from "vitest";
import { exportGlb } from "../../../../web/src/formats/glb";
import { model } from "../../../../web/src/models/growth/index";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { grownParts } from "../../formats/grown_parts";
import { documentOf } from "../../formats/reading";

/** Kinds of bark by species: Vaucher, Tree Bark (2003). */
const KINDS: Readonly<Record<string, string>> = {
	oak: "furrowed",
	birch: "paper",
	pine: "plated",
	cherry: "banded",
	cypress: "stringy",
	beech: "smooth",
};

it("the presets name the kind of bark of their species", () => {
	for (const [name, kind] of Object.entries(KINDS))
		expect([name, model.table.option(fromPreset(model, name), "bark_kind")]).toEqual([name, kind]);
});

it("six species have six normal maps of bark in GLB", async () => {
	const maps = new Set<string>();
	for (const name of Object.keys(KINDS)) {
		const { parts, about } = await grownParts(`growth/${name}`, { age: 12 });
		const wood = [...parts()].filter(({ shape }) => shape?.material.name === "Bark");
		const file = exportGlb(wood, about);
		const { textures = [], images = [], bufferViews = [] } = documentOf(file);
		const texture = textures.find((each) => each.name === "Bark normal");
		const view = bufferViews[images[texture?.source ?? 0].bufferView];
		const bytes = Buffer.from(file).subarray(view.byteOffset, view.byteOffset + view.byteLength);
		maps.add(`${texture?.name} ${bytes.toString("latin1")}`);
	}
	expect(maps.size).toBe(6);
}, 60_000);
