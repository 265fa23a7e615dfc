/** The time of a recent plant, in words: "edited 2 hours ago". */
import { ago } from "./ago";
import { text } from "./messages.generated";
import type { RecentPlant } from "./recent_plant";

/**
 * Returns when a plant was edited or opened, in words.
 * @param now milliseconds since 1970
 */
export function timeInWords({ at, editedAt }: RecentPlant, now: number): string {
	const time = ago(editedAt ?? at, now);
	if (editedAt !== undefined) return time === undefined ? text("edited_now") : text("edited", { ago: time });
	return time === undefined ? text("opened_now") : text("opened", { ago: time });
}
