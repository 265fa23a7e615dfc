/** The measures and the drawing of docs/models/leaf/likeness.md, which compares leaf presets with real leaves. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { moduleOf, repository } from "../../wasm-core/tools/repository.mjs";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { exportJson } from "../../web/src/formats/json";
import { model } from "../../web/src/models/leaf/index";
import { leafFromPreset } from "../../web/src/models/leaf/schema";
import type { DocsFile } from "./docs_file";
import { figureOf } from "./leaf_veins";

const PAGE = "docs/models/leaf/likeness.md";
const PICTURE = "docs/models/leaf/likeness.svg";

type Measures = Record<string, number>;

/** By the page's name of a measure: its value from a leaf's measures and parameters, and its number of decimals. */
const MEASURED: Record<string, [value: (measures: Measures, parameters: Measures) => number, decimals: number]> = {
	"blade length, mm": [({ leaf_length }) => leaf_length, 0],
	"blade width, mm": [({ leaf_width }) => leaf_width, 0],
	"main vein N1, mm": [(_, { length }) => length, 0],
	"petiole, mm": [(_, { petiole, length }) => (petiole / 100) * length, 1],
	primaries: [({ count_1 }) => count_1, 0],
	"angle between primaries, °": [({ primary_angle }) => primary_angle, 0],
	"primaries together, in N1": [({ density_1, area }, { length }) => (density_1 * area * 10) / length, 1],
	"secondaries on a side": [({ count_2 }) => count_2 / 2, 1],
	"angle of secondaries, °": [({ secondary_angle }) => secondary_angle, 0],
	"spacing of secondaries, mm": [({ secondary_spacing }) => secondary_spacing, 1],
	"1° length per area, cm/cm²": [({ density_1 }) => density_1, 2],
	"2° length per area, cm/cm²": [({ density_2 }) => density_2, 2],
	"3° length per area, cm/cm²": [({ density_3 }) => density_3, 2],
};

/** A row of the page's tables: | measure | ours | real | how sure | source | under a heading that names the preset. */
export interface Row {
	readonly preset: string;
	readonly measure: string;
	readonly ours: string;
	/** Of real leaves; undefined where no number was found. */
	readonly range?: [number, number];
	readonly line: string;
}

function rowsOf(text: string): Row[] {
	const rows: Row[] = [];
	let preset = "";
	for (const line of text.split("\n")) {
		preset = /^### .*`leaf\/([a-z-]+)`/.exec(line)?.[1] ?? preset;
		const [, measure, ours, real] = line.split("|").map((cell) => cell.trim());
		if (!preset || !measure || !(measure in MEASURED)) continue;
		const bounds = /^([\d.]+) … ([\d.]+)$/.exec(real);
		rows.push({ preset, measure, ours, range: bounds ? [Number(bounds[1]), Number(bounds[2])] : undefined, line });
	}
	return rows;
}

/** The rows of the page as it is committed. */
export const committedRows = () => rowsOf(readFileSync(join(repository, PAGE), "utf8"));

function grow(core: Awaited<ReturnType<typeof loadCoreFromBytes>>, preset: string) {
	const specimen = leafFromPreset(preset);
	const leaf = model.read(core.grow(model.encode(specimen, { meshes: false })));
	const { measures } = exportJson(model, leaf, specimen) as unknown as { measures: Measures };
	const measured = (measure: string) => {
		const [value, decimals] = MEASURED[measure];
		return value(measures, specimen.parameters).toFixed(decimals);
	};
	return { leaf, measured, millimetres: specimen.parameters.length };
}

/**
 * Grows the presets of the page.
 * @returns `measured`: a measure as the page prints it; `files`: the page and its drawing
 */
export async function growLikeness() {
	const core = await loadCoreFromBytes(readFileSync(moduleOf("particles")));
	const rows = committedRows();
	const presets = [...new Set(rows.map(({ preset }) => preset))];
	const grown = new Map(presets.map((preset) => [preset, grow(core, preset)]));
	const measured = ({ preset, measure }: Row) => grown.get(preset)!.measured(measure);
	let page = readFileSync(join(repository, PAGE), "utf8");
	for (const row of rows) page = page.replace(row.line, row.line.replace(`| ${row.ours} |`, `| ${measured(row)} |`));
	const picture = figureOf([...grown].map(([name, { leaf, millimetres }]) => ({ name, leaf, millimetres })));
	const files: DocsFile[] = [
		{ path: PAGE, text: page },
		{ path: PICTURE, text: picture },
	];
	return { measured, files };
}
