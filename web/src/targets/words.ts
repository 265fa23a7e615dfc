/** Describes the results of targets. */
import { displayedNumber, displayScaleOf } from "../specimen/lengths";
import { measureText } from "../specimen/measures";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";
import { reachedText, toleranceOf } from "./aim";
import type { AimResult, Solution } from "./solve";

/** "Bunch length: 160 mm reached", or "Bunch length: 300 mm asked, 158.9 mm reached; nothing goes further". */
export function reachedInWords({ info, value, within, measured, isReached, hasLever, isAtLimit }: AimResult): string {
	const target = measureText(info, value);
	if (isReached && Math.abs(measured - value) <= toleranceOf(info, value)) return `${info.label}: ${target} reached`;
	if (isReached && within)
		return `${info.label}: ${reachedText(info, measured, value)} reached, within ${measureText(info, within[0])} to ${measureText(info, within[1])}`;
	if (!Number.isFinite(measured)) return `${info.label}: this has none`;
	const end = !hasLever ? "; nothing moves it" : isAtLimit ? "; what moves it goes no further" : "";
	return `${info.label}: ${target} asked, ${reachedText(info, measured, value)} reached${end}`;
}

/** The most changes that are listed; the others are counted. */
const MOST_NAMED = 3;

/** Differences between two specimens, the largest first: "Length 120 → 143.4 mm, Density 6 → 7.1 and 3 more". */
export function changesInWords<S extends Specimen>(
	species: Pick<ModelSchema<S>, "table" | "lengths">,
	from: S,
	to: S,
): string {
	const active = species.table.core.filter((entry) => species.table.isActive(to, entry));
	const changes = active.flatMap((entry) => {
		// Compare lengths in the displayed unit: one that only follows its scale has not changed.
		if (from.parameters[entry.key] === to.parameters[entry.key]) return [];
		const values = [from, to].map((each) => {
			const scale = displayScaleOf(species, each, entry);
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
	const named = changes.sort((one, other) => other.share - one.share).slice(0, MOST_NAMED);
	const more = changes.length > named.length ? ` and ${changes.length - named.length} more` : "";
	return `${named.map(({ words }) => words).join(", ")}${more}`;
}

/** How many growths it took: "in 6 growths". */
export const growthsInWords = ({ growths }: Pick<Solution, "growths">): string =>
	`in ${growths} ${growths === 1 ? "growth" : "growths"}`;
