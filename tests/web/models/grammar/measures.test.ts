import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { exportJson } from "../../../../web/src/formats/json";
import type { GrammarPlant } from "../../../../web/src/models/grammar/grammar_plant";
import { model } from "../../../../web/src/models/grammar/index";
import type { AreaRecord } from "../../../../web/src/models/grammar/record";
import type { GrammarRequestOptions } from "../../../../web/src/models/grammar/request";
import type { GrammarSpecimen } from "../../../../web/src/models/grammar/specimen";
import { fetchTexts } from "../../../../web/src/models/grammar/texts";
import { readout } from "../../../../web/src/models/grammar/ui/readout";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { freshCore } from "../../core/wasm";
import { complaints } from "../../formats/reading";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	core = await freshCore("grammar.wasm");
});

const grow = (specimen: GrammarSpecimen, options?: GrammarRequestOptions): GrammarPlant =>
	model.read(core.grow(model.encode(specimen, options)), specimen);
const measuresOf = (preset: string) => {
	const specimen = fromPreset(model, preset);
	return exportJson(model, grow(specimen, { meshes: false }), specimen).measures;
};

/** Returns a template's text without tags. */
function textOf(drawn: unknown): string {
	if (Array.isArray(drawn)) return drawn.map(textOf).join("");
	const { strings, values } = (drawn ?? {}) as { strings?: readonly string[]; values?: readonly unknown[] };
	if (!strings) return typeof drawn === "symbol" ? "" : String(drawn ?? "");
	return strings.map((text, i) => text + textOf(values?.[i])).join("");
}

describe("measures of published texts", () => {
	it("are those that theory has: a Koch island", () => {
		expect(measuresOf("koch-island")).toMatchObject({
			segments: 4 * 8 ** 3,
			line_length: expect.closeTo((4 * 8 ** 3) / 100, 3),
			tips: 1,
			forks: 0,
			axes: 1,
			axis_order: 0,
			order: 1,
			bifurcation: null,
			organs: 0,
			leaf_area: 0,
			areas: null,
			clothed: null,
		});
	});

	it("are those that theory has: a binary tree", () => {
		const length = Array.from({ length: 10 }, (_, k) => (2 / 1.456) ** k).reduce((sum, each) => sum + each, 0);
		expect(measuresOf("binary-tree")).toMatchObject({
			segments: 1023,
			tips: 512,
			forks: 511,
			axes: 1023,
			axis_order: 9,
			order: 10,
			bifurcation: expect.closeTo(2, 4),
			fork_angle: expect.closeTo(170, 2),
			line_length: expect.closeTo(length / 100, 3),
		});
	});

	it("are not taken while the next is on its way", () => {
		expect(grow(fromPreset(model, "binary-tree"), { preview: true }).measures).toBeUndefined();
	});
});

describe("growth areas", () => {
	it("are listed with their contents, in the JSON document and in the page", () => {
		const specimen = { ...fromPreset(model, "topiary-two-cubes"), constants: { part: 12 } };
		const grown = grow(specimen, { meshes: false });
		const json = exportJson(model, grown, specimen);
		const areas = json.areas as Required<AreaRecord>[];
		expect(areas.map(({ volume }) => volume)).toEqual([expect.closeTo(1, 5), expect.closeTo(0.85 ** 3, 5)]);
		expect(json.measures).toMatchObject({
			areas: 2,
			area_volume: expect.closeTo(1 + 0.85 ** 3, 5),
			clothed: Math.min(...areas.map(({ clothed }) => clothed)),
		});
		const between = grown.belongs?.area.filter((area) => area === 0).length ?? 0;
		expect(areas[0].segments + areas[1].segments + between).toBe(grown.segments.count);
		const words = textOf(readout(grown)).replaceAll(/<[^>]*>/g, " ");
		expect(words).toContain(areas[1].segments.toLocaleString("en-GB"));
		expect(words).toMatch(/2 box .* 0\.614 .* \d\d %/);
		expect(textOf(readout(grow(fromPreset(model, "binary-tree"))))).not.toContain("Growth areas");
	});
});

describe("a leaf with a thickness", () => {
	const leaf = (constants: Record<string, number> = {}) => ({ ...fromPreset(model, "leaf-ovate"), constants });

	it("is a closed blade a quarter of a millimetre thick, measured by its sheet's area", () => {
		const [thick, thin] = [grow(leaf()), grow(leaf({ thick: 0 }))].map((grown) => {
			const mesh = grown.meshes.find(({ name }) => name === "blades");
			if (!mesh) throw new Error("There are no blades.");
			const key = grown.measures?.[model.table.measures.findIndex(({ key }) => key === "leaf_area")] ?? 0;
			return { ...mesh, area: key / 1e4 };
		});
		const at = (corner: number) => [0, 1, 2].map((k) => thick.positions[3 * thick.indices[corner] + k]);
		let volume = 0;
		for (let i = 0; i < thick.indices.length; i += 3) {
			const [a, b, c] = [at(i), at(i + 1), at(i + 2)];
			volume +=
				a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
		}
		expect(volume / 6 / (thick.area * 0.00027)).toBeGreaterThan(0.99);
		expect(volume / 6 / (thick.area * 0.00027)).toBeLessThan(1.01);
		expect(thick.area).toBeCloseTo(thin.area, 8);
		// Both faces, and two triangles for each side.
		const corners = thin.positions.length / 3;
		expect(thin.indices.length / 3).toBe(corners - 2);
		expect(thick.indices.length / 3).toBe(4 * corners - 4);
	});

	it("becomes a valid GLB with the shown triangles", async () => {
		const specimen = leaf();
		const grown = grow(specimen);
		const about = await aboutPlant(model, grown, specimen);
		const shown = [...model.parts(grown, specimen)].find(({ name }) => name === "Blade");
		expect(shown?.shape?.mesh.indices.length).toBe(grown.meshes.find(({ name }) => name === "blades")?.indices.length);
		expect(await complaints(exportGlb(model.parts(grown, specimen), about, {}))).toEqual([]);
	});
});
