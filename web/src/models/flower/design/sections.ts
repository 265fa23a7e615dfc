/** Generates each organ's section of the text: its description's line and the grammar that follows from it. */
import { type Bladed, bladeText } from "./blade";
import { type Description, lineOf } from "./description";
import type { Organ } from "./organs";
import { filled } from "./template";
import pistil from "./templates/pistil.gl3?raw";
import stamen from "./templates/stamen.gl3?raw";
import stem from "./templates/stem.gl3?raw";
import { type Call, ringFor, whorlText } from "./whorl";

const SIDES: Readonly<Record<string, number>> = { round: 12, oval: 12, square: 4, triangular: 3 };
const LEANS: Readonly<Record<string, number>> = { erect: 0, arching: 2.2, nodding: 5 };

function stemText({ values }: Description): string {
	return filled(stem, {
		...values,
		sides: SIDES[String(values.section)],
		flat: values.section === "oval" ? 0.55 : 1,
		lean: LEANS[String(values.growth)],
	});
}

/** Stem segment above a node, which bends like segments without a node (templates/stem.gl3). */
const BENT_STEM = "STEM(,,<bend*step/6>,,,,,)";

/** Generates the nodes of the stem with their leaves; nodes are part of the stem's module. */
function leafText(description: Description): string {
	const { values } = description;
	const count = Number(values.count);
	if (count === 0) return "";
	const basal = values.arrangement === "basal";
	const each = basal ? 3 : values.arrangement === "opposite" ? 2 : 1;
	const nodes = Math.ceil(count / each);
	// A node takes one step and the stem segment above it another; the last node must come before the stem's end.
	const apart = Math.min(4, Math.floor(MOST_STEPS / nodes));
	const lines = Array.from({ length: nodes }, (_, i) => {
		const node = `NODE${i + 1}`;
		const above = basal && i < nodes - 1 ? `NODE${i + 2}` : BENT_STEM;
		const faces = Array.from({ length: Math.min(each, count - i * each) }, (_, k) => nodeFace(each, i, k));
		return [
			`#define ${node}(sides,0,0,0,${basal ? "1+0.3*thick" : "piece"},thick,thick,1)`,
			...(basal && i > 0 ? [] : [`STEM{}{step==${i * apart + Number(apart > 2 && !basal)}}{} -> STEM[${node}]_{E}`]),
			`${node} -> ${node}[${above}]_{E}`,
			`${node} -> ${node}[${leafOn(values, round(1 - 0.08 * i))}]_{${faces.join(",")}}`,
		];
	}).flat();
	return `${[...lines, ...stalkLines(values)].join("\n")}\n\n${bladeText("leaf", description)}`;
}

type Values = Description["values"];

/** Returns the leaf on a node, or its stalk, which then has the leaf's rise. */
function leafOn({ stalk, angle }: Values, part: number): string {
	if (Number(stalk) === 0) return `&LEAF{part=${part}}`;
	return `STALK(,<${-Number(angle)}>,,,<${round(Number(stalk) * part)}>,,,)`;
}

/** Generates the stalk, whose length scales its leaf; it has as many sides as a blade's vein. */
function stalkLines({ stalk, angle, thickness }: Values): string[] {
	if (Number(stalk) === 0) return [];
	return [
		`#define STALK(8,0,0,0,${stalk},${thickness},${thickness},1)`,
		`STALK -> STALK[&LEAF{part=H/${stalk}; tilt=${-Number(angle)}}]_{E}`,
	];
}

/** Returns the face of a node for its leaf `k`, counted in twelfths of a turn, since stems have 12, 4 or 3 sides. */
function nodeFace(each: number, node: number, k: number): string {
	const twelfth = each === 1 ? (node * 5) % 12 : (k * (12 / each) + node * (each === 2 ? 3 : 2)) % 12;
	return `C(1+floor(${twelfth}*sides/12))`;
}

/** Steps of the stem in which nodes can be placed. */
const MOST_STEPS = 16;

const BLADE_RINGS = { sepal: 1, petal: 4 } as const;

function bladedWhorl(organ: "sepal" | "petal", description: Description): string {
	const { values } = description;
	const count = Number(values.count);
	const ring = whorlText({
		organ,
		count,
		whorls: Number(values.whorls ?? 1),
		radius: Number(values.radius),
		material: count > 0 ? BLADE_RINGS[organ] : 1,
		call: values.symmetry === "irregular" ? lipped(Number(values.lip) / 100) : inward,
	});
	return count === 0 ? ring : `${ring}\n${bladeText(organ as Bladed, description)}`;
}

/** Settings of inner whorls, which are smaller and steeper. */
const inward: Call = (whorl) => (whorl === 0 ? "" : `{part=${round(1 - 0.08 * whorl)}; tilt=${6 * whorl}}`);

/** Settings of irregular whorls: upper and lower lips differ in size and angle. The first face points down. */
const lipped =
	(lip: number): Call =>
	(whorl, face, sides) => {
		const down = Math.cos((2 * Math.PI * (face - 1)) / sides);
		return `{part=${round((1 + lip * down) * (1 - 0.08 * whorl))}; tilt=${round(6 * whorl - 22 * down * Math.sign(lip))}}`;
	};

function stamenText({ values }: Description): string {
	const count = Number(values.count);
	const ring = whorlText({
		organ: "stamen",
		count,
		whorls: Number(values.whorls),
		radius: Number(values.radius),
		material: count > 0 ? 6 : 1,
		call: inward,
	});
	if (count === 0) return ring;
	const basifixed = values.attachment === "basifixed";
	const pieces = basifixed ? 5 : 3;
	return `${ring}\n${filled(stamen, {
		...values,
		joint: round(Math.max(Number(values.thickness), Number(values.anther) * 0.2)),
		// A dorsifixed anther is held in its middle: one half on each side of the filament.
		faces: basifixed ? "E" : "C1,C3",
		pieces: basifixed ? 5 : 6,
		end: 8 + pieces,
		middle: basifixed ? 2 : 0,
		taper: basifixed ? 0.1 : 0.16,
	})}`;
}

function pistilText({ values }: Description): string {
	const count = Number(values.count);
	const apart = values.fusion === "apocarpous";
	const ring = whorlText({
		organ: "pistil",
		count: apart ? count : 0,
		whorls: 1,
		radius: Number(values.radius),
		material: count > 0 ? 8 : 1,
		call: () => "",
	});
	if (count === 0) return ring;
	const { sides, faces } = apart ? { sides: 6, faces: [1, 3, 5] } : ringFor(count, 0);
	const joined = apart ? "" : "RING1 -> RING1[&PISTIL]_{E}\n";
	return `${ring}${joined}\n${filled(pistil, {
		...values,
		sides,
		// The more carpels, the smaller each.
		share: apart ? round(Math.min(1, 3.5 / count)) : 1,
		start: apart ? `-${values.angle}+math.random(-3,3)` : "0",
		lobes: faces.map((face) => `C${face}`).join(","),
	})}`;
}

const round = (value: number): number => Math.round(value * 1000) / 1000 + 0;

const MAKERS: Readonly<Record<Organ, (description: Description) => string>> = {
	stem: stemText,
	leaf: leafText,
	sepal: (description) => bladedWhorl("sepal", description),
	petal: (description) => bladedWhorl("petal", description),
	stamen: stamenText,
	pistil: pistilText,
};

/** Generates an organ's section: its description's line, its grammar and an empty line. */
export function sectionOf(description: Description): string {
	return `${lineOf(description)}\n${MAKERS[description.organ](description)}\n`;
}
