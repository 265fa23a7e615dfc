/** Goals of a series: target measures of each plant, one value for all or drawn from a range. */
import type { MeasureInfo } from "../specimen/measures";
import type { Table } from "../specimen/table";
import type { Aim } from "../targets/aim";
import type { Draws } from "./draws";

export interface Goal {
	/** The key of the measure. */
	readonly measure: string;
	/** In the measure's unit; a share from 0 to 1. */
	readonly from: number;
	/** Equal to `from` for a single value. */
	readonly to: number;
}

/** Returns the text for `--target`: `160`, `120..160`. */
export const formatGoal = ({ from, to }: Goal): string => (from === to ? String(from) : `${from}..${to}`);

/** Returns the targets of a plant, by its number: uniformly drawn from ranges. */
export function aimsOf(
	{ measures }: Pick<Table, "measures">,
	goals: readonly Goal[],
	draws: Draws,
	number: number,
): Aim[] {
	return goals.map((goal) => {
		const { measure, from, to } = goal;
		if (from === to) return { measure, value: from };
		const share = draws.share(`target ${measure}`, number);
		return {
			measure,
			value: drawn(
				goal,
				share,
				measures.find(({ key }) => key === measure),
			),
			within: [from, to],
		};
	});
}

/** Significant digits of a drawn value. */
const DIGITS = 6;

/**
 * Returns the value at a share of a goal's range: a whole number for measures that count, else rounded to `DIGITS`.
 */
function drawn({ from, to }: Goal, share: number, info: MeasureInfo | undefined): number {
	if (info?.kind === "whole") return Math.ceil(from) + Math.floor(share * (Math.floor(to) - Math.ceil(from) + 1));
	return Number((from + share * (to - from)).toPrecision(DIGITS));
}
