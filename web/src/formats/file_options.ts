/** Options of files with meshes: one table of their limits, for every place that reads them from outside. */
import type { Message } from "../locale/texts";
import { text } from "./messages.generated";

/** Options of a file; a file ignores those that it does not use. */
export interface FileOptions {
	/** Largest number of triangles of the forms *low* and *wind*. */
	readonly triangles?: number;
	/** Whether flesh is translucent in the forms *detailed* and *instanced*; a reader draws it in a second pass. */
	readonly translucent?: boolean;
	/**
	 * Whether pictures hold colours, shade, roughness and relief in the form *detailed*, in place of vertices and
	 * materials.
	 */
	readonly textures?: boolean;
	/** Whether the first vertex colours of the form *game* hold wind data, in place of shade. */
	readonly windColours?: boolean;
	/** Least thickness of any part in files for printers, in millimetres. */
	readonly thickness?: number;
	/** Number of points of a point cloud. */
	readonly points?: number;
}

/** A numeric option: its limits, inclusive. */
export interface NumericFileOption {
	readonly least: number;
	readonly most: number;
	/** Whether only whole numbers are accepted. */
	readonly whole: boolean;
}

export const NUMERIC_FILE_OPTIONS = {
	triangles: { least: 100, most: 2_000_000, whole: true },
	thickness: { least: 0.2, most: 20, whole: false },
	points: { least: 1, most: 2_000_000, whole: true },
} as const satisfies Partial<Record<keyof FileOptions, NumericFileOption>>;

export type NumericFileOptionKey = keyof typeof NUMERIC_FILE_OPTIONS;

/** Options that are on or off. */
export const SWITCH_FILE_OPTIONS = ["translucent", "textures"] as const satisfies readonly (keyof FileOptions)[];

/** Returns whether a value is a number that the option accepts. */
export function isFileOptionValue(key: NumericFileOptionKey, value: unknown): value is number {
	const { least, most, whole }: NumericFileOption = NUMERIC_FILE_OPTIONS[key];
	return typeof value === "number" && value >= least && value <= most && (!whole || Number.isInteger(value));
}

/**
 * Returns the message on a value that the option does not accept: "triangles must be a whole number from 100 to
 * 2,000,000."
 * @param option the option's name for the user
 */
export function fileOptionProblem(key: NumericFileOptionKey, option: string = key): Message {
	const { least, most, whole }: NumericFileOption = NUMERIC_FILE_OPTIONS[key];
	return text.message(whole ? "option_whole_number" : "option_number", { option, least, most });
}

/** Number keys of a set of options, in the order of the table. */
export const NUMERIC_FILE_OPTION_KEYS = Object.keys(NUMERIC_FILE_OPTIONS) as readonly NumericFileOptionKey[];

/** Returns the accepted values in words: "a whole number from 100 to 2000000". */
export function fileOptionRange(key: NumericFileOptionKey): string {
	const { least, most, whole }: NumericFileOption = NUMERIC_FILE_OPTIONS[key];
	return `a ${whole ? "whole " : ""}number from ${least} to ${most}`;
}
