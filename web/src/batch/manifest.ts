/**
 * The manifest of a series, `series.json` beside its table: everything that determines its files. Two calls with equal
 * manifests make the same files, so that one can continue another; series with different manifests must not share a
 * folder.
 */

import type { FileOptions } from "../formats/file_options";
import { GENERATOR } from "../formats/generator";
import { DEFAULT_SEED } from "../specimen/from_preset";
import { encodeQuery, textsOf } from "../specimen/link";
import { formatGoal } from "./goals";
import { text } from "./messages.generated";
import type { Series } from "./series";
import type { Varied } from "./vary";

export const MANIFEST = "series.json";

export interface Manifest {
	/** The program and its version: another one may grow other plants. */
	readonly program: string;
	/** `bunch/riesling`. */
	readonly preset: string;
	/** Settings of all plants besides the preset, by the keys of links. */
	readonly settings: Readonly<Record<string, string>>;
	/** Texts in place of the presets', by the keys of links. */
	readonly texts: Readonly<Record<string, string>>;
	readonly draws: "independent" | "literal";
	/** Numbers of all plants, in the form of `--seeds`. */
	readonly plants: string;
	/** The number of parts of the series, each with its own table. */
	readonly parts: number;
	/** By parameter: `60..110` or `lychee|duku`. */
	readonly vary: Readonly<Record<string, string>>;
	/** Target values by the keys of measures. */
	readonly targets: Readonly<Record<string, string>>;
	/** Kinds of files. */
	readonly files: readonly string[];
	/** Options of the files: `points`, `triangles` and others. */
	readonly options: FileOptions;
}

/**
 * Builds the manifest of a series, with the values that differ from the preset.
 * @param numbers numbers of all plants, including those of other parts
 */
export function manifestOf(series: Series, numbers: readonly number[], parts = 1): Manifest {
	const { model, from, varied, goals = [], draws, formats, options = {} } = series;
	const common = { ...from, seed: DEFAULT_SEED };
	const settings = Object.fromEntries(new URLSearchParams(encodeQuery(model, common)));
	const { v, model: _, preset: __, ...others } = settings;
	return {
		program: GENERATOR,
		preset: `${model.name}/${from.preset}`,
		settings: { v, ...others },
		texts: Object.fromEntries(textsOf(model, common)),
		draws: draws.literal ? "literal" : "independent",
		plants: formatRanges(numbers),
		parts,
		vary: Object.fromEntries(varied.map((each) => [each.entry.key, formatVaried(each)])),
		targets: Object.fromEntries(goals.map((goal) => [goal.measure, formatGoal(goal)])),
		...{ files: formats, options },
	};
}

/** Returns the text of the file. */
export const formatManifest = (manifest: Manifest): string => `${JSON.stringify(manifest, null, "\t")}\n`;

/**
 * Returns the differences between a manifest that was read and another, in the terms of the command line: `--seeds:
 * 1-12 there, 5-8 here`.
 * @param there any text; a text that is not a manifest is one difference
 */
export function differencesFrom(there: string, here: Manifest): string[] {
	const before = labelValues(parseObject(there));
	if (before.size === 0) return [text("manifest_unreadable", { file: MANIFEST })];
	const now = labelValues(here);
	return [...new Set([...before.keys(), ...now.keys()])].flatMap((label) => {
		const [one, other] = [before.get(label), now.get(label)];
		if (one === other) return [];
		return [text("manifest_difference", { setting: label, there: quoteValue(one), here: quoteValue(other) })];
	});
}

const LABELS: Readonly<Record<keyof Manifest, string>> = {
	program: "program",
	preset: "preset",
	settings: "--set",
	texts: "text",
	draws: "draws",
	plants: "--seeds",
	parts: "parts of --shard",
	vary: "--vary",
	targets: "--target",
	files: "--as",
	options: "option",
};

/** Returns every value of a manifest by its label in messages. */
function labelValues(manifest: object): Map<string, string> {
	const values = new Map<string, string>();
	for (const [key, value] of Object.entries(manifest)) {
		const label = LABELS[key as keyof Manifest] ?? key;
		if (typeof value !== "object" || value === null || Array.isArray(value)) values.set(label, String(value));
		else for (const [part, own] of Object.entries(value)) values.set(`${label} ${part}`, String(own));
	}
	return values;
}

/** Parses a JSON object; empty for any other text. */
function parseObject(written: string): object {
	try {
		const value: unknown = JSON.parse(written);
		return typeof value === "object" && value !== null ? value : {};
	} catch {
		return {};
	}
}

/** The most characters of a value in a message. */
const SHOWN = 40;

/** Returns a value as messages quote it: words in place of a long or missing one. */
function quoteValue(value: string | undefined): string {
	if (value === undefined) return text("manifest_none");
	return value.length > SHOWN || value.includes("\n") ? text("manifest_other_text") : value;
}

/** Returns numbers in the form of `--seeds`, neighbours as ranges: `1-12,20`. */
function formatRanges(numbers: readonly number[]): string {
	const ranges: [first: number, last: number][] = [];
	for (const number of numbers) {
		const run = ranges.at(-1);
		if (run && number === run[1] + 1) run[1] = number;
		else ranges.push([number, number]);
	}
	return ranges.map(([first, last]) => (first === last ? `${first}` : `${first}-${last}`)).join(",");
}

/** Returns the values of a varied parameter in the form of `--vary`. */
const formatVaried = (varied: Varied): string =>
	"values" in varied ? varied.values.join("|") : `${varied.from}..${varied.to}`;
