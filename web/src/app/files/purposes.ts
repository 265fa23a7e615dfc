/** Chooses and groups the files of the download sheet: one recommended file for each purpose, and all files by kind. */
import { text } from "../messages.generated";
import type { DownloadFormat } from "./formats";

/** Purposes of a file, in the order of the sheet. */
export const PURPOSES = ["program", "website", "game", "printing", "ar", "picture", "data"] as const;
export type Purpose = (typeof PURPOSES)[number];

/** Keys of the formats that suit a purpose, the best first. */
const SUITABLE: Readonly<Record<Purpose, readonly string[]>> = {
	program: ["glb", "obj"],
	website: ["glb-web"],
	game: ["zip-game", "glb-low"],
	printing: ["3mf", "stl"],
	ar: ["usdz"],
	picture: ["png"],
	data: ["csv", "json"],
};

const TITLES: Readonly<Record<Purpose, () => string>> = {
	program: () => text("purpose_program"),
	website: () => text("purpose_website"),
	game: () => text("purpose_game"),
	printing: () => text("purpose_printing"),
	ar: () => text("purpose_ar"),
	picture: () => text("purpose_picture"),
	data: () => text("purpose_data"),
};

/** The programs that open a recommended format, by its key. */
const OPENED_BY: Readonly<Record<string, () => string>> = {
	glb: () => text("opened_by_glb"),
	obj: () => text("opened_by_obj"),
	"glb-web": () => text("opened_by_glb_web"),
	"glb-low": () => text("opened_by_glb_low"),
	"zip-game": () => text("opened_by_zip_game"),
	"3mf": () => text("opened_by_3mf"),
	stl: () => text("opened_by_3mf"),
	usdz: () => text("opened_by_usdz"),
	png: () => text("opened_by_png"),
	csv: () => text("opened_by_csv"),
	json: () => text("opened_by_json"),
};

export interface Recommended {
	readonly purpose: Purpose;
	readonly title: string;
	readonly format: DownloadFormat;
	/** The programs that open the file, in a sentence. */
	readonly openedBy: string;
}

/**
 * Recommends a format for each purpose; purposes without a suitable format are left out.
 * @param canMake false for formats whose file cannot be made, such as one that would be too large
 */
export function recommendedFormats(
	formats: readonly DownloadFormat[],
	canMake: (format: DownloadFormat) => boolean = () => true,
): Recommended[] {
	return PURPOSES.flatMap((purpose) => {
		const suitable = SUITABLE[purpose].flatMap((key) => formats.find((format) => format.key === key) ?? []);
		const format = suitable.find(canMake) ?? suitable[0];
		if (!format) return [];
		return { purpose, title: TITLES[purpose](), format, openedBy: OPENED_BY[format.key]?.() ?? format.about };
	});
}

/** The kinds of files, in the order of the sheet. */
const KINDS = ["models", "animations", "printing", "pictures", "data"] as const;
type Kind = (typeof KINDS)[number];

const KIND_TITLES: Readonly<Record<Kind, () => string>> = {
	models: () => text("formats_models"),
	animations: () => text("formats_animations"),
	printing: () => text("formats_printing"),
	pictures: () => text("formats_pictures"),
	data: () => text("formats_data"),
};

const ANIMATED = ["glb-growth", "glb-wind"];

/** Kinds by the ending of the file's name; other files are data. */
const KIND_OF: Readonly<Record<string, Kind>> = {
	".glb": "models",
	".usdz": "models",
	".zip": "models",
	".ply": "models",
	".3mf": "printing",
	".stl": "printing",
	".png": "pictures",
	".svg": "pictures",
};

export interface FormatGroup {
	readonly title: string;
	readonly formats: readonly DownloadFormat[];
}

/** Groups all formats by the kind of their files, in their order; empty groups are left out. */
export function groupedFormats(formats: readonly DownloadFormat[]): FormatGroup[] {
	const kindOf = ({ key, suffix }: DownloadFormat): Kind =>
		ANIMATED.includes(key) ? "animations" : (KIND_OF[suffix.slice(suffix.lastIndexOf("."))] ?? "data");
	return KINDS.flatMap((kind) => {
		const own = formats.filter((format) => kindOf(format) === kind);
		return own.length > 0 ? { title: KIND_TITLES[kind](), formats: own } : [];
	});
}
