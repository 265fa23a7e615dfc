import type { LitElement } from "lit";
import type { Studio } from "../studio";
import { fetchFailed } from "../types";

/** A part of the page that is loaded when first opened: its tag is in the page, its script is fetched. */
export interface LatePart {
	readonly tag: string;
	load(): Promise<unknown>;
	/** Title of the notice if loading fails: "The help could not be loaded". */
	failed(): string;
}

interface Openable extends LitElement {
	open(): void | Promise<void>;
}

/** Opens the element of a part. */
const openElement = (element: Openable): void | Promise<void> => element.open();

/**
 * Loads a part and opens it; errors are shown as notices.
 * @param use does something else with its element
 */
export async function openPart<E extends Openable>(
	studio: Studio,
	part: LatePart,
	use: (element: E) => void | Promise<void> = openElement,
): Promise<void> {
	try {
		await part.load();
	} catch {
		const again = () => void openPart(studio, part, use);
		return studio.notify(part.failed(), fetchFailed(), { again });
	}
	try {
		const element = document.querySelector<E>(part.tag);
		await element?.updateComplete;
		if (element) await use(element);
	} catch (error) {
		studio.notify(part.failed(), [error instanceof Error ? error.message : String(error)]);
	}
}
