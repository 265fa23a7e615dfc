import type { NoticeOptions } from "../ui/editor_context";
import { text } from "./messages.generated";

/** The reason why there is no plant, shown in its place. */
export interface Failure {
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
	/** Actions that may help: the same request again, or another specimen. */
	readonly remedies: readonly Remedy[];
}

/** The source of a document from outside; the topic of notices about it. */
export type RestoredFrom = "link" | "file" | "saved specimen";

export type Remedy = "again" | "other";

/**
 * Returns the details of a notice about a script that could not be fetched: some browsers retry only when the page is
 * loaded again.
 */
export const fetchFailed = (): string[] => [text("fetch_failed"), text("fetch_failed_advice")];

/** A message to the user, shown until it is dismissed. */
export interface Notice extends Readonly<NoticeOptions> {
	readonly id: number;
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
}
