/**
 * Organs of a designed flower, the six control points of Petrenko 2014 (section 3.3), with the fields that describe
 * each.
 */
import { OUTLINES } from "./shapes";

export const ORGANS = ["stem", "leaf", "sepal", "petal", "stamen", "pistil"] as const;
export type Organ = (typeof ORGANS)[number];

interface Named {
	readonly key: string;
	readonly label: string;
	readonly help: string;
}
export interface NumberField extends Named {
	readonly kind: "number";
	readonly least: number;
	readonly most: number;
	readonly step: number;
	readonly unit: string;
	readonly usual: number;
}
export interface ChoiceField extends Named {
	readonly kind: "choice";
	readonly options: readonly string[];
	readonly usual: string;
}
export interface ColourField extends Named {
	readonly kind: "colour";
	readonly usual: string;
}
export type OrganField = NumberField | ChoiceField | ColourField;

type FieldRange = readonly [least: number, most: number, step: number];

const number = (
	key: string,
	label: string,
	unit: string,
	usual: number,
	range: FieldRange,
	help: string,
): NumberField => {
	const [least, most, step] = range;
	return { kind: "number", key, label, unit, usual, least, most, step, help };
};
const choice = (
	key: string,
	label: string,
	options: readonly string[],
	help: string,
	usual = options[0],
): ChoiceField => ({
	kind: "choice",
	key,
	label,
	options,
	help,
	usual,
});
const colours = (
	base: string,
	tip: string,
	[one, other] = ["Colour at the foot", "Colour at the tip"],
): ColourField[] => [
	{ kind: "colour", key: "base", label: one, help: "Where it begins.", usual: base },
	{ kind: "colour", key: "tip", label: other, help: "Where it ends.", usual: tip },
];

/** Fields shared by leaves, sepals and petals, which one template generates. */
function blade(outline: string, length: number, width: number, thickness: number): OrganField[] {
	return [
		choice("outline", "Outline", OUTLINES, "The shape of its margin, or one that is drawn.", outline),
		choice(
			"section",
			"Cross-section",
			["flat", "cupped", "channelled", "keeled", "wavy"],
			"Its form across.",
			"cupped",
		),
		number("length", "Length", "mm", length, [2, 400, 0.5], "From its foot to its tip."),
		number("width", "Width", "mm", width, [0.5, 200, 0.5], "Where it is widest."),
		number("thickness", "Thickness", "mm", thickness, [0.2, 6, 0.1], "Of its vein; its three layers share it."),
	];
}

const held = (angle: number, bend: number, curl: number): OrganField[] => [
	number("angle", "Rise", "°", angle, [-60, 90, 1], "0 stands out, 90 stands up."),
	number("bend", "Bend", "°", bend, [-150, 150, 1], "In all, along its length; below 0 inwards."),
	number("curl", "Tip’s bend", "°", curl, [-120, 150, 1], "What the last third bends besides."),
];

const radius = (usual: number): NumberField =>
	number("radius", "Radius of the whorl", "mm", usual, [0.5, 25, 0.1], "How far from the axis it stands.");
const count = (usual: number, most: number, help: string): NumberField =>
	number("count", "Count", "", usual, [0, most, 1], help);

export const FIELDS: Readonly<Record<Organ, readonly OrganField[]>> = {
	stem: [
		choice("section", "Cross-section", ["round", "oval", "square", "triangular"], "Its form across."),
		choice("growth", "Growth", ["erect", "arching", "nodding"], "How it stands."),
		number("length", "Length", "mm", 240, [10, 900, 5], "From the ground to the flower."),
		number("thickness", "Thickness", "mm", 5, [0.8, 24, 0.1], "Across."),
		...colours("7f9a55", "9ab36c"),
	],
	leaf: [
		count(2, 8, "Of the whole stem."),
		choice("arrangement", "Arrangement", ["alternate", "opposite", "basal"], "How they stand on the stem."),
		...blade("lanceolate", 150, 34, 1.4),
		number("stalk", "Stalk", "mm", 0, [0, 120, 0.5], "From the stem to the blade; 0: it sits on the stem."),
		...held(62, 24, 10),
		...colours("587f58", "6c9a64"),
	],
	sepal: [
		count(0, 12, "In one whorl; 0: there is no calyx."),
		...blade("ovate", 14, 8, 0.5),
		...held(30, -20, 0),
		radius(4),
		...colours("8aa356", "9fb868"),
	],
	petal: [
		count(5, 21, "In one whorl; 0: there is no corolla."),
		number("whorls", "Whorls", "", 1, [1, 3, 1], "So many of that count, in each other’s gaps."),
		choice("symmetry", "Symmetry", ["radial", "irregular"], "Irregular: one plane divides it, and its lips differ."),
		number(
			"lip",
			"Lips",
			"%",
			35,
			[-70, 70, 1],
			"Of irregular ones: how much the lower are larger; below 0 the upper.",
		),
		...blade("obovate", 32, 24, 0.8),
		...held(35, -25, 15),
		number("veins", "Veins", "", 0, [0, 12, 1], "Darker lines from the middle to the margin, so many a side."),
		radius(4.5),
		...colours("e8c34a", "f2d23a"),
	],
	stamen: [
		count(5, 24, "In one whorl; 0: there are none."),
		number("whorls", "Whorls", "", 1, [1, 4, 1], "So many of that count, in each other’s gaps."),
		choice(
			"attachment",
			"Anthers",
			["basifixed", "dorsifixed"],
			"Whether the filament holds the anther at its foot or at its back.",
		),
		number("length", "Filament", "mm", 14, [1, 120, 0.5], "Its length."),
		number("thickness", "Thickness", "mm", 0.9, [0.2, 4, 0.1], "Of the filament."),
		number("anther", "Anther", "mm", 5, [0.5, 30, 0.1], "Its length."),
		number("angle", "Rise", "°", 68, [-20, 90, 1], "0 stands out, 90 stands up."),
		number("bend", "Bend", "°", -10, [-120, 120, 1], "Along the filament; below 0 inwards."),
		radius(3.6),
		...colours("e8dfa5", "d7a53a", ["Colour of filaments", "Colour of anthers"]),
	],
	pistil: [
		count(3, 16, "Carpels; 0: there are none."),
		choice(
			"fusion",
			"Carpels",
			["syncarpous", "apocarpous"],
			"Syncarpous: grown together into one; apocarpous: each for itself.",
		),
		number("length", "Ovary", "mm", 12, [0.5, 60, 0.5], "Its length."),
		number("width", "Ovary’s width", "mm", 6, [0.4, 30, 0.1], "Where it is widest."),
		number("style", "Style", "mm", 5, [0.2, 120, 0.2], "Its length."),
		number("stigma", "Stigma", "mm", 3, [0.2, 20, 0.1], "Its width."),
		number("angle", "Rise", "°", 60, [0, 90, 1], "Of apocarpous carpels: 0 stands out, 90 stands up."),
		radius(2.4),
		...colours("a3b873", "e3dfa0", ["Colour of ovaries", "Colour of stigmas"]),
	],
};
