/**
 * `npm run bench -- fit`: how closely bunches follow the outline that the handles draw: the nine grape shapes of the paper's
 * Table 3 and fifty random profiles, grown by the natural procedure and by the paper's, and the octahedron by itself.
 * `npm run docs -- fit` writes the table into docs/measuring.md.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { runnerImport } from "vite";
import { moduleOf, repository } from "../../wasm-core/tools/repository.mjs";
import { octahedronFit } from "./octahedron_fit.mjs";

const RANDOM_PROFILES = 50;
const SIDES = ["p3", "p4", "p5", "p6"];
const WAYS = ["natural", "paper", "octahedron"];
const AIMS = { mean: { coverage: 0.92, spill: 0.03 }, worst: { coverage: 0.85, spill: 0.06 } };

const source = async (path) => (await runnerImport(join(repository, path))).module;
const { encodeRequest } = await source("web/src/models/bunch/request.ts");
const { readBunchPlant } = await source("web/src/models/bunch/read_bunch_plant.ts");
const { Core } = await source("web/src/core/core.ts");
const { PROCEDURES } = await source("web/src/models/bunch/bunch_plant.ts");
const { PRESETS } = await source("web/src/models/bunch/presets/presets.ts");
const { specimenFromPreset } = await source("web/src/models/bunch/schema.ts");
const { measureOf } = await source("web/src/models/bunch/measures.ts");
const { envelopePath } = await source("web/src/models/bunch/profile/envelope.ts");
const { metresPerPixel } = await source("web/src/models/bunch/profile/handles.ts");

const core = await Core.instantiate(new WebAssembly.Module(readFileSync(moduleOf("bunch"))));

/** The table as Markdown, and whether the aims are reached. */
export function fitTable() {
	const shapes = PRESETS.filter(({ kind, parameters }) => kind === "shape" && !parameters.wing).map(
		({ name, title }) => ({
			title,
			specimen: specimenFromPreset(name),
		}),
	);
	const random = Array.from({ length: RANDOM_PROFILES }, (_, index) => ({
		title: `random ${index + 1}`,
		specimen: randomSpecimen(index),
	}));
	return page(shapes.map(measured), random.map(measured));
}

/** An even draw from 0 up to 1, the same on every run: an integer hash of where it is used. */
function draw(index, place) {
	let x = (index * 16 + place + 1) * 0x9e3779b1;
	for (const by of [0x85ebca6b, 0xc2b2ae35]) {
		x = Math.imul(x ^ (x >>> 15), by);
	}
	return ((x ^ (x >>> 16)) >>> 0) / 2 ** 32;
}

function randomSpecimen(index) {
	const specimen = specimenFromPreset("long-conical");
	const { parameters } = specimen;
	specimen.seed = index + 1;
	parameters.l = Math.round(150 + 430 * draw(index, 0));
	for (const [i, side] of SIDES.entries()) {
		parameters[`${side}w`] = Math.round(30 + 190 * draw(index, 1 + i));
		parameters[`${side}r`] = Math.round(0.7 * parameters.l * draw(index, 5 + i));
	}
	// The octahedron is the handles'; so is the outline, then.
	parameters.variability = 0;
	return specimen;
}

/** Coverage and spill of a specimen, by each way of making a bunch of it. */
function measured({ title, specimen }) {
	const fits = PROCEDURES.map((name, procedure) => [
		name,
		grownFit({ ...specimen, parameters: { ...specimen.parameters, procedure } }),
	]);
	const { parameters } = specimen;
	const points = SIDES.map((side) => `${parameters[`${side}w`]} × ${parameters[`${side}r`]}`);
	const drawn = `l ${parameters.l}; ${points.join(", ")}`;
	return { title, drawn, ...Object.fromEntries(fits), octahedron: bareFit(parameters) };
}

function grownFit(specimen) {
	const { measures, berries } = readBunchPlant(core.grow(encodeRequest(specimen, { meshes: false })));
	const of = (key) => measureOf(measures, key);
	return { coverage: of("coverage"), spill: of("spill"), berries: berries.count };
}

/** Of the octahedron itself, against the natural bunch's outline, grown by the radius of a berry. */
function bareFit(parameters) {
	const natural = { ...parameters, procedure: PROCEDURES.indexOf("natural") };
	const radius = natural.size / 2 / (1000 * metresPerPixel(natural.unit));
	const outlines = ["front", "side"].map((view) => {
		const numbers = envelopePath(natural, view)
			.match(/-?[\d.]+/g)
			.map(Number);
		return numbers.flatMap((x, i) => (i % 2 ? [] : [{ x, y: numbers[i + 1] }]));
	});
	return octahedronFit(natural, outlines, radius);
}

function page(shapeRows, randomRows) {
	const heads = ["", ...WAYS.flatMap((way) => [`${way}: coverage`, "spill"]), "natural berries"];
	const line = (cells) => `| ${cells.join(" | ")} |`;
	const row = ({ title, ...fits }) => [
		title,
		...WAYS.flatMap((way) => [fits[way].coverage.toFixed(3), fits[way].spill.toFixed(3)]),
		fits.natural.berries ?? "",
	];
	const all = [...shapeRows, ...randomRows];
	return [
		line(heads),
		line(heads.map(() => "---")),
		...shapeRows.map((one) => line(row(one))),
		...summaries("nine shapes", shapeRows).map((one) => line(row(one))),
		...summaries(`${RANDOM_PROFILES} random profiles`, randomRows).map((one) => line(row(one))),
		"",
		verdict(all),
		...all
			.filter(misses)
			.map(
				({ title, drawn, natural }) =>
					`- ${title} (${drawn}): coverage ${natural.coverage.toFixed(3)}, spill ${natural.spill.toFixed(3)}`,
			),
	].join("\n");
}

function mean(values) {
	return values.reduce((sum, value) => sum + value, 0) / values.length;
}

function summaries(title, rows) {
	const of = (way, key) => rows.map((row) => row[way][key]);
	const both = (cover, spill) => (way) => [
		way,
		{ coverage: cover(of(way, "coverage")), spill: spill(of(way, "spill")) },
	];
	const least = (values) => Math.min(...values);
	const most = (values) => Math.max(...values);
	return [
		{ title: `**${title}**, mean`, ...Object.fromEntries(WAYS.map(both(mean, mean))) },
		{ title: `**${title}**, worst`, ...Object.fromEntries(WAYS.map(both(least, most))) },
	];
}

function misses({ natural }) {
	return natural.coverage < AIMS.worst.coverage || natural.spill > AIMS.worst.spill;
}

function verdict(rows) {
	const coverage = rows.map(({ natural }) => natural.coverage);
	const spill = rows.map(({ natural }) => natural.spill);
	const reached = mean(coverage) >= AIMS.mean.coverage && mean(spill) <= AIMS.mean.spill && !rows.some(misses);
	return (
		`For all ${rows.length} outlines, bunches of the natural procedure have a mean coverage of ${mean(coverage).toFixed(3)} ` +
		`(at least ${Math.min(...coverage).toFixed(3)})\nand a mean spill of ${mean(spill).toFixed(3)} ` +
		`(at most ${Math.max(...spill).toFixed(3)}). The aims are ${reached ? "reached." : "not reached:\n"}`
	);
}
