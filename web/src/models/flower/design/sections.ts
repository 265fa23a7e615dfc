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
const BEND_PER_STEP: Readonly<Record<string, number>> = { erect: 0, arching: 2.2, nodding: 5 };

/** Writes the section of the stem from its template. */
function stemText({ values }: Description): string {
	return filled(stem, {
		...values,
		sides: SIDES[String(values.section)],
		flat: values.section === "oval" ? 0.55 : 1,
		lean: BEND_PER_STEP[String(values.growth)],
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
	const leavesPerNode = basal ? 3 : values.arrangement === "opposite" ? 2 : 1;
	const nodes = Math.ceil(count / leavesPerNode);
	// A node takes one step and the stem segment above it another; the last node must come before the stem's end.
	const stepsApart = Math.min(4, Math.floor(MAX_STEPS / nodes));
	const lines = Array.from({ length: nodes }, (_, i) => {
		const node = `NODE${i + 1}`;
		const above = basal && i < nodes - 1 ? `NODE${i + 2}` : BENT_STEM;
		const faces = Array.from({ length: Math.min(leavesPerNode, count - i * leavesPerNode) }, (_, k) =>
			nodeFace(leavesPerNode, i, k),
		);
		return [
			`#define ${node}(sides,0,0,0,${basal ? "1+0.3*thick" : "piece"},thick,thick,1)`,
			...(basal && i > 0
				? []
				: [`STEM{}{step==${i * stepsApart + Number(stepsApart > 2 && !basal)}}{} -> STEM[${node}]_{E}`]),
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

/**
 * Returns the face of a node for its leaf `k`, as text. Positions are counted in twelfths of a turn, since stems have
 * 12, 4 or 3 sides.
 * @param each leaves per node
 * @param node number of the node
 */
function nodeFace(each: number, node: number, k: number): string {
	const twelfth = each === 1 ? (node * 5) % 12 : (k * (12 / each) + node * (each === 2 ? 3 : 2)) % 12;
	return `C(1+floor(${twelfth}*sides/12))`;
}

/** Steps of the stem in which nodes can be placed. */
const MAX_STEPS = 16;

/** Material number of the stem, and of rings without organs, whose own material is not in the text. */
const STEM_MATERIAL = 1;
/** Material number of the ring on which organs grow: for sepals the stem's, for others the organ's own. */
const RING_MATERIAL = { sepal: STEM_MATERIAL, petal: 4, stamen: 6, pistil: 8 } as const;

/**
 * Writes the whorls of sepals or petals, and below them the blade that they use; without organs only the empty whorl.
 */
function bladedWhorl(organ: "sepal" | "petal", description: Description): string {
	const { values } = description;
	const count = Number(values.count);
	const ring = whorlText({
		organ,
		count,
		whorls: Number(values.whorls ?? 1),
		radius: Number(values.radius),
		material: count > 0 ? RING_MATERIAL[organ] : STEM_MATERIAL,
		call: values.symmetry === "irregular" ? irregularSettings(Number(values.lip) / 100) : regularSettings,
	});
	return count === 0 ? ring : `${ring}\n${bladeText(organ as Bladed, description)}`;
}

/** Settings of inner whorls, which are smaller and steeper. */
const regularSettings: Call = (whorl) => (whorl === 0 ? "" : `{part=${round(1 - 0.08 * whorl)}; tilt=${6 * whorl}}`);

/**
 * Returns a function that returns the settings of an organ in an irregular whorl: upper and lower lips differ in size
 * and angle. The first face points down.
 * @param lip −1 … 1: how much larger the lower lip is
 */
const irregularSettings =
	(lip: number): Call =>
	(whorl, face, sides) => {
		const down = Math.cos((2 * Math.PI * (face - 1)) / sides);
		return `{part=${round((1 + lip * down) * (1 - 0.08 * whorl))}; tilt=${round(6 * whorl - 22 * down * Math.sign(lip))}}`;
	};

/** Writes the section of the stamens; only their ring if there are none. */
function stamenText({ values }: Description): string {
	const count = Number(values.count);
	const ring = whorlText({
		organ: "stamen",
		count,
		whorls: Number(values.whorls),
		radius: Number(values.radius),
		material: count > 0 ? RING_MATERIAL.stamen : STEM_MATERIAL,
		call: regularSettings,
	});
	if (count === 0) return ring;
	const basifixed = values.attachment === "basifixed";
	const antherPieces = basifixed ? 5 : 3;
	return `${ring}\n${filled(stamen, {
		...values,
		joint: round(Math.max(Number(values.thickness), Number(values.anther) * 0.2)),
		// A dorsifixed anther is held in its middle: one half on each side of the filament.
		faces: basifixed ? "E" : "C1,C3",
		pieces: basifixed ? 5 : 6,
		end: 8 + antherPieces,
		middle: basifixed ? 2 : 0,
		taper: basifixed ? 0.1 : 0.16,
	})}`;
}

/** Writes the section of the pistils: free ones in a ring, or one that carpels form together. */
function pistilText({ values }: Description): string {
	const count = Number(values.count);
	const isApocarpous = values.fusion === "apocarpous";
	const ring = whorlText({
		organ: "pistil",
		count: isApocarpous ? count : 0,
		whorls: 1,
		radius: Number(values.radius),
		material: count > 0 ? RING_MATERIAL.pistil : STEM_MATERIAL,
		call: () => "",
	});
	if (count === 0) return ring;
	const { sides, faces } = isApocarpous ? { sides: 6, faces: [1, 3, 5] } : ringFor(count, 0);
	const joined = isApocarpous ? "" : "RING1 -> RING1[&PISTIL]_{E}\n";
	return `${ring}${joined}\n${filled(pistil, {
		...values,
		sides,
		// The more carpels, the smaller each.
		share: isApocarpous ? round(Math.min(1, 3.5 / count)) : 1,
		start: isApocarpous ? `-${values.angle}+math.random(-3,3)` : "0",
		lobes: faces.map((face) => `C${face}`).join(","),
	})}`;
}

/** Rounds to thousandths. */
const round = (value: number): number => Math.round(value * 1000) / 1000 + 0;

const TEXT_OF: Readonly<Record<Organ, (description: Description) => string>> = {
	stem: stemText,
	leaf: leafText,
	sepal: (description) => bladedWhorl("sepal", description),
	petal: (description) => bladedWhorl("petal", description),
	stamen: stamenText,
	pistil: pistilText,
};

/** Generates an organ's section: its description's line, its grammar and an empty line. */
export function sectionOf(description: Description): string {
	return `${lineOf(description)}\n${TEXT_OF[description.organ](description)}\n`;
}
