/** Writes the grammars of leaves, sepals and petals from the template templates/petal_like.gl3. */
import type { Description } from "./description";
import { widthOf } from "./margin";
import { valueAt } from "./polynomial";
import { DRAWN, fitOf, type OutlineFit, SHAPES } from "./shapes";
import { filled } from "./template";
import petalLike from "./templates/petal_like.gl3?raw";

export type Bladed = "leaf" | "sepal" | "petal";
/** Material number of each organ's upper epidermis; plus 10 is its mesophyll, plus 20 its lower epidermis. */
const MATERIALS: Readonly<Record<Bladed, number>> = { leaf: 2, sepal: 3, petal: 4 };
/** Layers of a blade, with how much paler each is than the upper side, which has the chosen colours. */
const LAYERS = [
	{ name: "upper epidermis", paler: 0 },
	{ name: "mesophyll", paler: 0.1 },
	{ name: "lower epidermis", paler: 0.18 },
] as const;
const PALE = "e2e6d2";

/** Per cross-section: degrees by which a lobe turns up against the one before, and by which margins wave. */
const SECTIONS: Readonly<Record<string, readonly [cup: number, wave: number]>> = {
	flat: [1, 0],
	cupped: [7, 0],
	channelled: [18, 0],
	keeled: [-14, 0],
	wavy: [4, 14],
};

/** Returns the polynomial of a blade's outline, for a shape of the table as for a drawn margin. */
export function outlineOf({ values, margin }: Description): OutlineFit {
	if (values.outline === DRAWN && margin) return fitOf({ width: widthOf(margin) });
	return fitOf(SHAPES[String(values.outline)] ?? SHAPES.elliptic);
}

/** Returns the number of lobes to a side that the blade's width can show. */
function lobes(width: number, length: number): number {
	const share = width / length;
	return share < 0.1 ? 1 : share < 0.3 ? 2 : 3;
}

/** Returns whether a template line names a lobe beyond the last one, whose volume would never grow. */
const namesBeyond = (line: string, lobeCount: number): boolean =>
	[...line.matchAll(/\b[RL][UML](\d)/g)].some(([, lobe]) => Number(lobe) > lobeCount);

/** Returns the grammar of a leaf, sepal or petal. */
export function bladeText(organ: Bladed, description: Description): string {
	const { values } = description;
	const [length, width, angle] = [Number(values.length), Number(values.width), Number(values.angle)];
	const [bend, curl] = [Number(values.bend), Number(values.curl)];
	const { coefficients, even, fan } = outlineOf(description);
	const [cup, wave] = SECTIONS[String(values.section)];
	const material = MATERIALS[organ];
	const opens = organ !== "leaf";
	// The turn of a part of the blade, as an expression of the grammar: `share` of the bend when open, another in bud
	// and wilted.
	const turnOf = (share: number, extra = 0): string => {
		const degrees = round(bend * share + extra);
		return opens
			? `${degrees}*open-${round(50 * share)}*(1-open)+${round(24 * share)}*wilt`
			: `${degrees}+${round(30 * share)}*wilt`;
	};
	const lobeCount = lobes(width, length);
	const template = petalLike
		.split("\n")
		.filter((line) => !namesBeyond(line, lobeCount))
		.join("\n");
	return filled(template, {
		module: organ.toUpperCase(),
		steps: 12,
		lobes: lobeCount,
		length,
		width,
		thickness: values.thickness,
		grown: opens ? "(0.55+0.45*open)" : "1",
		even: Number(even),
		rise: opens ? `${angle}+${86 - angle}*(1-open)-18*wilt` : String(angle),
		low: turnOf(0.45),
		mid: turnOf(0.35),
		high: turnOf(0.2, curl),
		cup,
		wave: `${wave}${opens ? "+8*wilt" : ""}`,
		fan,
		upper: material,
		middle: material + 10,
		lower: material + 20,
		materials: LAYERS.map(({ name, paler }, layer) => {
			const [base, tip] = [values.base, values.tip].map((colour) => mixed(String(colour), PALE, paler));
			const clauses = lifeColours(organ, { ...values, base, tip, veins: layer === 0 ? values.veins : 0 });
			return `#material ${material + 10 * layer} ${organ} "${base}" "${tip}"${clauses} name "${organ}, ${name}"`;
		}).join("\n"),
		"width polynomial": horner(coefficients),
	});
}

/** Writes a polynomial by Horner's scheme: `c0+s*(c1+s*(…))`. */
function horner(coefficients: readonly number[]): string {
	const [first, ...rest] = coefficients;
	return rest.length === 0 ? String(first) : `${first}+s*(${horner(rest)})`;
}

const GREEN = "8d9c4e";
const BROWN = "8a6a40";

/**
 * Returns the clauses that follow a `#material`: its colours as a bud (greener) and when wilting (browner), and of
 * petals the veins.
 */
function lifeColours(organ: Bladed, { base, tip, veins }: Description["values"]): string {
	const wilted = ` wilted "${mixed(String(base), BROWN, 0.5)}" "${mixed(String(tip), BROWN, 0.6)}"`;
	if (organ !== "petal") return wilted;
	const lines = Number(veins) > 0 ? ` veins "${mixed(String(tip), "200808", 0.55)}" ${veins} 0.35` : "";
	return `${lines} bud "${mixed(String(base), GREEN, 0.7)}" "${mixed(String(tip), GREEN, 0.5)}"${wilted}`;
}

/**
 * Mixes two colours, six hexadecimal digits each.
 * @param share 0 for the first one … 1 for the other
 */
function mixed(one: string, other: string, share: number): string {
	const channel = (of: string, at: number): number => Number.parseInt(of.slice(at, at + 2), 16);
	return [0, 2, 4]
		.map((at) => Math.round(channel(one, at) * (1 - share) + channel(other, at) * share))
		.map((value) => value.toString(16).padStart(2, "0"))
		.join("");
}

/** Rounds to hundredths. */
const round = (value: number): number => Math.round(value * 100) / 100 + 0;

/** Returns the half width, as a share of the greatest, at a share `t` of the steps, as the grammar computes it. */
export const halfWidthAt = ({ coefficients }: OutlineFit, t: number): number =>
	Math.max(0.004, valueAt(coefficients, t));
