import type { NoticeOptions } from "../controls/desk";

/** Why there is no plant at all, said in its place. */
export interface Failure {
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
	/** What may bring one: the same request again, or another specimen. */
	readonly remedies: readonly Remedy[];
}

export type Remedy = "again" | "other";

/** Something said to the person, until it is dismissed. */
export interface Notice extends Readonly<NoticeOptions> {
	readonly id: number;
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
}
