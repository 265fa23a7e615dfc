/** The texts of presets. They are no part of what a page loads first: they are fetched together when one is asked for. */
import { PRESETS } from "./presets.generated";
import type { StandSpecimen } from "./specimen";

let texts: Readonly<Record<string, string>> | undefined;

const textNames = new Map(PRESETS.map(({ name, text }) => [name, text]));

/** Fetches them; rejects where that fails, and tries again with the next call. */
export async function fetchTexts(): Promise<void> {
	texts ??= (await import("./texts.generated")).TEXTS;
}

/** What a stand is laid by; undefined where that is its preset's and has not been fetched. */
export function fetchedText({ grammar, preset }: Pick<StandSpecimen, "grammar" | "preset">): string | undefined {
	return grammar ?? texts?.[textNames.get(preset) ?? ""];
}
