/** Targets for measures. */
import { type MeasureInfo, measureText } from "../specimen/measures";

export interface Aim {
	/** The key of the measure. */
	readonly measure: string;
	/** In the measure's unit; a share from 0 to 1. */
	readonly value: number;
	/** The range in which the measure counts as reached, where `value` was drawn from a range. */
	readonly within?: readonly [from: number, to: number];
}

/** Relative tolerance: a value counts as reached within this share, or half of the last displayed digit. */
const NEAR_ENOUGH = 0.0025;

/** The largest difference at which a value counts as reached. */
export function toleranceOf(info: MeasureInfo, value: number): number {
	return Math.max(digitOf(info) / 2, NEAR_ENOUGH * Math.abs(value));
}

/** One step of the last displayed digit. */
export function digitOf({ kind, decimals }: MeasureInfo): number {
	return 10 ** -(kind === "share" ? decimals + 2 : decimals);
}

/** The text of a reached value, with one more digit where only that distinguishes it from the target. */
export function reachedText(info: MeasureInfo, value: number, target: number): string {
	const text = measureText(info, value);
	const finer = { ...info, decimals: info.decimals + 1 };
	return info.kind !== "whole" &&
		text === measureText(info, target) &&
		measureText(finer, value) !== measureText(finer, target)
		? measureText(finer, value)
		: text;
}

/** The value of a number as users write it for a measure: shares in percent. */
export const fromWritten = ({ kind }: MeasureInfo, written: number): number =>
	kind === "share" ? written / 100 : written;

/** The number to write for a measure's value, without its unit. */
export function writtenFor(info: MeasureInfo, value: number): string {
	return (info.kind === "share" ? 100 * value : value).toFixed(info.decimals);
}
