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

/**
 * Returns the largest difference at which a value counts as reached: half of the last digit, or a small share of the
 * value.
 */
export function toleranceOf(info: MeasureInfo, value: number): number {
	return Math.max(digitOf(info) / 2, NEAR_ENOUGH * Math.abs(value));
}

/**
 * Returns one step of the last displayed digit, in the measure's own unit. Shares are displayed in percent, which has
 * two digits more.
 */
export function digitOf({ kind, decimals }: MeasureInfo): number {
	return 10 ** -(kind === "share" ? decimals + 2 : decimals);
}

/** Returns the text of a reached value, with one more digit where only that distinguishes it from the target. */
export function reachedText(info: MeasureInfo, value: number, target: number): string {
	const text = measureText(info, value);
	const finer = { ...info, decimals: info.decimals + 1 };
	return info.kind !== "whole" &&
		text === measureText(info, target) &&
		measureText(finer, value) !== measureText(finer, target)
		? measureText(finer, value)
		: text;
}

/** Returns the value of a number that users write for a measure: shares in percent. */
export const fromWritten = ({ kind }: MeasureInfo, written: number): number =>
	kind === "share" ? written / 100 : written;

/** Returns the number to write for a measure's value, without its unit. */
export function writtenFor(info: MeasureInfo, value: number): string {
	return (info.kind === "share" ? 100 * value : value).toFixed(info.decimals);
}
