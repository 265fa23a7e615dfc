/** The pure half of notices: which stand besides a new one, and which go. */
import type { Notice } from "./types";

const MOST_NOTICES = 3;

/** The newest at the end; the same words are not stacked, nor what is said of the same thing. */
export function withNotice(notices: readonly Notice[], notice: Notice): readonly Notice[] {
	const others = withoutTopic(notices, notice.topic).filter(({ title }) => title !== notice.title);
	return [...others, notice].slice(-MOST_NOTICES);
}

/** Those that hold though the document has changed; the same list where all do. */
export function afterChange(notices: readonly Notice[]): readonly Notice[] {
	return notices.some(({ untouched }) => untouched) ? notices.filter(({ untouched }) => !untouched) : notices;
}

/** Those that are about something else; the same list where all are. */
export function withoutTopic(notices: readonly Notice[], topic: string | undefined): readonly Notice[] {
	const others = notices.filter((notice) => topic === undefined || notice.topic !== topic);
	return others.length < notices.length ? others : notices;
}
