/** Describes the results of targets. */
import { formatList } from "../locale/format";
import { displayedNumber, displayScaleOf } from "../specimen/lengths";
import { measureText } from "../specimen/measures";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { reachedText, toleranceOf } from "./aim";
import { text } from "./messages.generated";
import type { AimResult, Solution } from "./solve";

/**
 * Returns the result of a target in words: "Bunch length: 160 mm reached", or "Bunch length: wanted 300 mm, got 158.9
 * mm (no setting affects it)".
 */
export function reachedInWords({ info, value, within, measured, isReached, hasLever, isAtLimit }: AimResult): string {
	const measure = info.label;
	const wanted = measureText(info, value);
	if (isReached && Math.abs(measured - value) <= toleranceOf(info, value))
		return text("reached", { measure, value: wanted });
	if (!Number.isFinite(measured)) return text("without_measure", { measure });
	const reached = reachedText(info, measured, value);
	if (isReached && within) {
		const [least, most] = within.map((each) => measureText(info, each));
		return text("reached_within", { measure, value: reached, least, most });
	}
	const key = !hasLever ? "missed_without_setting" : isAtLimit ? "missed_at_limit" : "missed";
	return text(key, { measure, wanted, reached });
}

/** The most changes that are listed; the others are counted. */
const MAX_NAMED = 3;

/** Differences between two specimens, the largest first: "Length 120 → 143.4 mm, Density 6 → 7.1 and 3 more". */
export function changesInWords<S extends Specimen>(
	schema: Pick<ModelSchema<S>, "table" | "lengths">,
	from: S,
	to: S,
): string {
	const active = schema.table.core.filter((entry) => schema.table.isActive(to, entry));
	const changes = active.flatMap((entry) => {
		// Compare lengths in the displayed unit: one that only follows its scale has not changed.
		if (from.parameters[entry.key] === to.parameters[entry.key]) return [];
		const values = [from, to].map((each) => {
			const scale = displayScaleOf(schema, each, entry);
			return {
				scale,
				exact: scale.per * each.parameters[entry.key],
				read: displayedNumber(scale, each.parameters[entry.key]),
			};
		});
		const [before, after] = values;
		// The same length in another unit is no change for users.
		if (before.read === after.read) return [];
		const [least, most] = values.map(({ exact }) => Math.max(exact, 0.01));
		// To one percent, so that parameters that move together stay in the table's order.
		const share = Math.round(100 * Math.abs(Math.log(most / least)));
		const { unit } = after.scale;
		return [{ share, words: `${entry.label} ${before.read} → ${after.read}${unit ? ` ${unit}` : ""}` }];
	});
	const named = changes.sort((one, other) => other.share - one.share).slice(0, MAX_NAMED);
	const more = changes.length - named.length;
	return formatList([...named.map(({ words }) => words), ...(more > 0 ? [text("more_changes", { count: more })] : [])]);
}

/** Returns how many growths a search took, in words: "after 6 tries". */
export const growthsInWords = ({ growths }: Pick<Solution, "growths">): string =>
	text("after_tries", { count: growths });
