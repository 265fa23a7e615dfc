/**
 * Organs of a designed flower, the six control points of Petrenko 2014 (section 3.3), with the fields that describe
 * each.
 */
import { text } from "../messages.generated";
import { OUTLINES } from "./shapes";

export const ORGANS = ["stem", "leaf", "sepal", "petal", "stamen", "pistil"] as const;
export type Organ = (typeof ORGANS)[number];

interface Named {
	readonly key: string;
	readonly label: string;
	readonly help: string;
}

/** A text in the language in use; fields are defined before the language is loaded. */
type TextGetter = () => string;

/** Returns the label and the help of a field as getters, because the language may be loaded later. */
const named = (label: TextGetter, help: TextGetter) => ({
	get label() {
		return label();
	},
	get help() {
		return help();
	},
});
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

/**
 * Describes a numeric field.
 * @param usual value of an organ without such a value
 * @param range least and greatest value, and step
 */
const number = (
	key: string,
	label: TextGetter,
	unit: string,
	usual: number,
	range: FieldRange,
	help: TextGetter,
): NumberField => {
	const [least, most, step] = range;
	return Object.assign(named(label, help), { kind: "number", key, unit, usual, least, most, step } as const);
};
/** Describes a field with a few options; the first is the default. */
const choice = (
	key: string,
	label: TextGetter,
	options: readonly string[],
	help: TextGetter,
	usual = options[0],
): ChoiceField => Object.assign(named(label, help), { kind: "choice", key, options, usual } as const);
/** Describes the two colour fields of an organ; colours are six hexadecimal digits. */
const colours = (
	base: string,
	tip: string,
	[one, other]: readonly [TextGetter, TextGetter] = [() => text("colour_base"), () => text("colour_tip")],
): ColourField[] => [
	Object.assign(
		named(one, () => text("colour_base_help")),
		{ kind: "colour", key: "base", usual: base } as const,
	),
	Object.assign(
		named(other, () => text("colour_tip_help")),
		{ kind: "colour", key: "tip", usual: tip } as const,
	),
];

/** Fields shared by leaves, sepals and petals, which one template generates. */
function blade(outline: string, length: number, width: number, thickness: number): OrganField[] {
	return [
		choice(
			"outline",
			() => text("outline"),
			OUTLINES,
			() => text("outline_help"),
			outline,
		),
		choice(
			"section",
			() => text("section"),
			["flat", "cupped", "channelled", "keeled", "wavy"],
			() => text("section_help"),
			"cupped",
		),
		number(
			"length",
			() => text("length"),
			"mm",
			length,
			[2, 400, 0.5],
			() => text("blade_length_help"),
		),
		number(
			"width",
			() => text("width"),
			"mm",
			width,
			[0.5, 200, 0.5],
			() => text("blade_width_help"),
		),
		number(
			"thickness",
			() => text("thickness"),
			"mm",
			thickness,
			[0.2, 6, 0.1],
			() => text("blade_thickness_help"),
		),
	];
}

/** Describes how an organ is placed and bent: angle, bend and curl in degrees. */
const posture = (angle: number, bend: number, curl: number): OrganField[] => [
	number(
		"angle",
		() => text("rise"),
		"°",
		angle,
		[-60, 90, 1],
		() => text("rise_help"),
	),
	number(
		"bend",
		() => text("bend"),
		"°",
		bend,
		[-150, 150, 1],
		() => text("bend_help"),
	),
	number(
		"curl",
		() => text("curl"),
		"°",
		curl,
		[-120, 150, 1],
		() => text("curl_help"),
	),
];

/** Describes the radius of the ring that organs of a whorl are on. */
const radius = (usual: number): NumberField =>
	number(
		"radius",
		() => text("radius"),
		"mm",
		usual,
		[0.5, 25, 0.1],
		() => text("radius_help"),
	);
/**
 * Describes the field for the number of organs.
 * @param usual value of an organ without such a value
 * @param most largest number
 */
const count = (usual: number, most: number, help: TextGetter): NumberField =>
	number("count", () => text("count"), "", usual, [0, most, 1], help);

export const FIELDS: Readonly<Record<Organ, readonly OrganField[]>> = {
	stem: [
		choice(
			"section",
			() => text("section"),
			["round", "oval", "square", "triangular"],
			() => text("section_help"),
		),
		choice(
			"growth",
			() => text("growth"),
			["erect", "arching", "nodding"],
			() => text("growth_help"),
		),
		number(
			"length",
			() => text("length"),
			"mm",
			240,
			[10, 900, 5],
			() => text("stem_length_help"),
		),
		number(
			"thickness",
			() => text("thickness"),
			"mm",
			5,
			[0.8, 24, 0.1],
			() => text("stem_thickness_help"),
		),
		...colours("7f9a55", "9ab36c"),
	],
	leaf: [
		count(2, 8, () => text("leaf_count_help")),
		choice(
			"arrangement",
			() => text("arrangement"),
			["alternate", "opposite", "basal"],
			() => text("arrangement_help"),
		),
		...blade("lanceolate", 150, 34, 1.4),
		number(
			"stalk",
			() => text("stalk"),
			"mm",
			0,
			[0, 120, 0.5],
			() => text("stalk_help"),
		),
		...posture(62, 24, 10),
		...colours("587f58", "6c9a64"),
	],
	sepal: [
		count(0, 12, () => text("sepal_count_help")),
		...blade("ovate", 14, 8, 0.5),
		...posture(30, -20, 0),
		radius(4),
		...colours("8aa356", "9fb868"),
	],
	petal: [
		count(5, 21, () => text("petal_count_help")),
		number(
			"whorls",
			() => text("whorls"),
			"",
			1,
			[1, 3, 1],
			() => text("whorls_help"),
		),
		choice(
			"symmetry",
			() => text("symmetry"),
			["radial", "irregular"],
			() => text("symmetry_help"),
		),
		number(
			"lip",
			() => text("lip"),
			"%",
			35,
			[-70, 70, 1],
			() => text("lip_help"),
		),
		...blade("obovate", 32, 24, 0.8),
		...posture(35, -25, 15),
		number(
			"veins",
			() => text("veins"),
			"",
			0,
			[0, 12, 1],
			() => text("veins_help"),
		),
		radius(4.5),
		...colours("e8c34a", "f2d23a"),
	],
	stamen: [
		count(5, 24, () => text("stamen_count_help")),
		number(
			"whorls",
			() => text("whorls"),
			"",
			1,
			[1, 4, 1],
			() => text("whorls_help"),
		),
		choice(
			"attachment",
			() => text("attachment"),
			["basifixed", "dorsifixed"],
			() => text("attachment_help"),
		),
		number(
			"length",
			() => text("filament"),
			"mm",
			14,
			[1, 120, 0.5],
			() => text("filament_help"),
		),
		number(
			"thickness",
			() => text("thickness"),
			"mm",
			0.9,
			[0.2, 4, 0.1],
			() => text("filament_thickness_help"),
		),
		number(
			"anther",
			() => text("anther"),
			"mm",
			5,
			[0.5, 30, 0.1],
			() => text("anther_help"),
		),
		number(
			"angle",
			() => text("rise"),
			"°",
			68,
			[-20, 90, 1],
			() => text("rise_help"),
		),
		number(
			"bend",
			() => text("bend"),
			"°",
			-10,
			[-120, 120, 1],
			() => text("filament_bend_help"),
		),
		radius(3.6),
		...colours("e8dfa5", "d7a53a", [() => text("colour_filaments"), () => text("colour_anthers")]),
	],
	pistil: [
		count(3, 16, () => text("carpel_count_help")),
		choice(
			"fusion",
			() => text("fusion"),
			["syncarpous", "apocarpous"],
			() => text("fusion_help"),
		),
		number(
			"length",
			() => text("ovary"),
			"mm",
			12,
			[0.5, 60, 0.5],
			() => text("ovary_help"),
		),
		number(
			"width",
			() => text("ovary_width_label"),
			"mm",
			6,
			[0.4, 30, 0.1],
			() => text("ovary_width_help"),
		),
		number(
			"style",
			() => text("style"),
			"mm",
			5,
			[0.2, 120, 0.2],
			() => text("style_help"),
		),
		number(
			"stigma",
			() => text("stigma"),
			"mm",
			3,
			[0.2, 20, 0.1],
			() => text("stigma_help"),
		),
		number(
			"angle",
			() => text("rise"),
			"°",
			60,
			[0, 90, 1],
			() => text("carpel_rise_help"),
		),
		radius(2.4),
		...colours("a3b873", "e3dfa0", [() => text("colour_ovaries"), () => text("colour_stigmas")]),
	],
};
