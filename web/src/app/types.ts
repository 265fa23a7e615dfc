import type { NoticeOptions } from "../ui/editor_context";

/** Why there is no plant at all, said in its place. */
export interface Failure {
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
	/** What may bring one: the same request again, or another specimen. */
	readonly remedies: readonly Remedy[];
}

export type Remedy = "again" | "other";

/** What to do where a script of the page did not come: some browsers ask for it again only when the page is loaded. */
export const TRY_AGAIN = "Check the connection and try again, or load the page again: the address holds what you have.";

/** Something said to the person, until it is dismissed. */
export interface Notice extends Readonly<NoticeOptions> {
	readonly id: number;
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
}
