import type { LitElement } from "lit";
import type { Studio } from "../studio";
import { TRY_AGAIN } from "../types";

/** A part of the page that is loaded when first opened: its tag is in the page, its script is fetched. */
export interface LatePart {
	readonly tag: string;
	load(): Promise<unknown>;
	/** Title of the notice if loading fails: "The help could not be fetched". */
	readonly failed: string;
}

interface Openable extends LitElement {
	open(): void | Promise<void>;
}

/** Opens a part; errors are shown as notices. @param place contains its element */
export async function openPart(studio: Studio, part: LatePart, place: ParentNode = document): Promise<void> {
	try {
		await part.load();
	} catch {
		const again = () => void openPart(studio, part, place);
		return studio.notify(part.failed, ["Part of the page could not be fetched.", TRY_AGAIN], { again });
	}
	try {
		const element = place.querySelector<Openable>(part.tag);
		await element?.updateComplete;
		await element?.open();
	} catch (error) {
		studio.notify(part.failed, [error instanceof Error ? error.message : String(error)]);
	}
}
