/** What a person asks of a measure. */
import { type MeasureInfo, measureText } from "../specimen/measures";

export interface Aim {
	/** The key of the measure. */
	readonly measure: string;
	/** In the measure's unit; a share from 0 to 1. */
	readonly value: number;
	/** Between which values the measure counts as met, where the value was drawn from a range. */
	readonly within?: readonly [from: number, to: number];
}

/** As near as counts as there: half of the last digit that is shown, or this share of the value. */
const NEAR_ENOUGH = 0.0025;

/** How far from a value counts as there. */
export function toleranceOf(info: MeasureInfo, value: number): number {
	return Math.max(digitOf(info) / 2, NEAR_ENOUGH * Math.abs(value));
}

/** One step of the last digit that is shown. */
export function digitOf({ kind, decimals }: MeasureInfo): number {
	return 10 ** -(kind === "share" ? decimals + 2 : decimals);
}

/** A value that was reached, with one digit more than is shown where that tells it from what was asked. */
export function reachedText(info: MeasureInfo, value: number, asked: number): string {
	const text = measureText(info, value);
	const finer = { ...info, decimals: info.decimals + 1 };
	return info.kind !== "whole" &&
		text === measureText(info, asked) &&
		measureText(finer, value) !== measureText(finer, asked)
		? measureText(finer, value)
		: text;
}

/** A number as people write it for a measure: shares in percent. */
export const fromWritten = ({ kind }: MeasureInfo, written: number): number =>
	kind === "share" ? written / 100 : written;

/** A measure's value as it is written to be asked for, without its unit. */
export function writtenFor(info: MeasureInfo, value: number): string {
	return (info.kind === "share" ? 100 * value : value).toFixed(info.decimals);
}
