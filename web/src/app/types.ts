import type { NoticeOptions } from "../ui/editor_context";

/** The reason why there is no plant, shown in its place. */
export interface Failure {
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
	/** Actions that may help: the same request again, or another specimen. */
	readonly remedies: readonly Remedy[];
}

export type Remedy = "again" | "other";

/** Advice after a failed fetch of a script: some browsers retry only when the page is loaded again. */
export const TRY_AGAIN = "Check the connection and try again, or load the page again: the address holds what you have.";

/** A message to the user, shown until it is dismissed. */
export interface Notice extends Readonly<NoticeOptions> {
	readonly id: number;
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
}
