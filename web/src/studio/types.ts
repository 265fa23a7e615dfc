import type { NumberKey } from "../models/bunch/parameters.generated";
import type { Locks } from "../models/bunch/profile/handles";
import type { Look } from "../specimen/specimen";

export type { Locks };

/** Which of the views a phone shows. */
export type View = "front" | "side" | "solid";

/** What a control changes; what it leaves out stays. */
export interface Change {
	seed?: number;
	parameters?: Partial<Record<NumberKey, number>>;
	look?: Partial<Look>;
}

/** Why there is no bunch at all, said in its place. */
export interface Failure {
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
	/** What may bring a bunch: the same request again, or another specimen. */
	readonly remedies: readonly Remedy[];
}

export type Remedy = "again" | "other";

/** Something said to the person, until it is dismissed. */
export interface Notice {
	readonly id: number;
	readonly title: string;
	/** One line each. */
	readonly details: readonly string[];
	/** Text to copy by hand, where the clipboard was denied. */
	readonly copy?: string;
	/** Goes by itself after a while: confirmations, never warnings. */
	readonly brief?: boolean;
}
