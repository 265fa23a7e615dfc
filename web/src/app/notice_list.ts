/** Pure functions on the list of notices: which stay and which are removed. */
import type { Notice } from "./types";

const MAX_NOTICES = 3;

/** Adds a notice at the end; removes notices with the same title or topic. */
export function withNotice(notices: readonly Notice[], notice: Notice): readonly Notice[] {
	const others = withoutTopic(notices, notice.topic).filter(({ title }) => title !== notice.title);
	return [...others, notice].slice(-MAX_NOTICES);
}

/** Returns the notices that stay after a change of the document; the same list if all do. */
export function afterChange(notices: readonly Notice[]): readonly Notice[] {
	return notices.some(({ untouched }) => untouched) ? notices.filter(({ untouched }) => !untouched) : notices;
}

/** Returns the notices about other topics; the same list if all are. */
export function withoutTopic(notices: readonly Notice[], topic: string | undefined): readonly Notice[] {
	const others = notices.filter((notice) => topic === undefined || notice.topic !== topic);
	return others.length < notices.length ? others : notices;
}
