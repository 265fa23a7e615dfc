/** Times as pages show them: "2 hours ago". */
import { localeTag } from "../../locale/locale";

const UNITS = [
	["year", 365 * 86_400],
	["month", 30 * 86_400],
	["week", 7 * 86_400],
	["day", 86_400],
	["hour", 3600],
	["minute", 60],
] as const;

/**
 * Returns the time between two moments in the language in use: "yesterday", "2 hours ago"; undefined for less than a
 * minute, and for times to come, which a clock that was set back leaves.
 * @param at milliseconds since 1970, as is `now`
 */
export function ago(at: number, now: number): string | undefined {
	const seconds = (now - at) / 1000;
	const unit = UNITS.find(([, length]) => seconds >= length);
	if (!unit) return undefined;
	return new Intl.RelativeTimeFormat(localeTag(), { numeric: "auto" }).format(-Math.floor(seconds / unit[1]), unit[0]);
}
