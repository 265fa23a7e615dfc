/**
 * `npm run pictures -- gallery-docs`: all presets of bunches from the front and from the side, with their measures, as
 * docs/gallery.md and docs/gallery/*.webp, to be compared with real fruit. Run it when growth, presets or the scene have changed.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { drawPresets } from "./preset_pictures.mjs";

const docs = new URL("../../docs/", import.meta.url);
const folder = new URL("gallery/", docs);
const PICTURE = { size: { width: 360, height: 480 }, oversampling: 2, quality: 0.8, theme: "light" };
const VIEWS = ["front", "side"];
const LARGEST = 40 * 1024;

const SECTIONS = [
	["shape", "Shapes", "The six shapes of the paper and its four real bunches; the figures are the paper's own."],
	["variety", "Varieties", "Named varieties; where their numbers come from is in [varieties](varieties.md)."],
	["fruit", "Other fruits", "The paper's other fruits, at their own size."],
];

/** Columns of the table of bunches: title and content. */
const COLUMNS = [
	["berries", ({ berry_count }) => whole(berry_count)],
	["length", ({ bunch_length }) => `${whole(bunch_length)} mm`],
	["width", ({ bunch_width }) => `${whole(bunch_width)} mm`],
	["weight", ({ bunch_weight }) => `${whole(bunch_weight)} g`],
	["coverage", ({ coverage }) => coverage.toFixed(3)],
	["spill", ({ spill }) => spill.toFixed(3)],
];

const whole = (value) => value.toFixed(0);

function row({ name, title, figure }, measures) {
	const shown = figure === undefined ? title : `${title}<br>figure ${figure}`;
	const pictures = VIEWS.map((view) => `<img src="gallery/${name}-${view}.webp" width="180" alt="${title}, ${view}">`);
	return `| ${[shown, ...pictures, ...COLUMNS.map(([, cell]) => cell(measures))].join(" | ")} |`;
}

function section([kind, title, about], rows) {
	const titles = ["", ...VIEWS, ...COLUMNS.map(([name]) => name)];
	const rule = titles.map((_, column) => (column > VIEWS.length ? "--:" : "---"));
	return [`## ${title}`, "", about, "", `| ${titles.join(" | ")} |`, `|${rule.join("|")}|`, ...rows[kind], ""].join(
		"\n",
	);
}

const HEAD = `# Gallery

Every preset as the app grows and draws it with seed 1, from the front and from the side. Length and width are the berries' own;
coverage and spill are explained in [measures](models/bunch/measures.md). Made by \`npm run pictures -- gallery-docs\`. Flowers stand with their sizes in [flower/species.md](models/flower/species.md), trees
in [growth/species.md](models/growth/species.md), stands in [stand.md](models/stand/stand.md).
`;

export async function render() {
	mkdirSync(folder, { recursive: true });
	const rows = { shape: [], variety: [], fruit: [] };
	let total = 0;
	await drawPresets("bunch", [{ ...PICTURE, views: VIEWS }], (preset, { pictures, measures }) => {
		for (const [view, bytes] of Object.entries(pictures)) {
			if (bytes.length > LARGEST)
				throw new Error(`${preset.name}-${view}.webp has ${bytes.length} bytes; lower the quality.`);
			total += bytes.length;
			writeFileSync(new URL(`${preset.name}-${view}.webp`, folder), bytes);
		}
		rows[preset.kind].push(row(preset, measures));
	});
	writeFileSync(new URL("gallery.md", docs), [HEAD, ...SECTIONS.map((each) => section(each, rows))].join("\n"));
	console.log(`docs/gallery: ${(total / 1024).toFixed(0)} kB in all`);
}
