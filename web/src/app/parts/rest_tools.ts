import type { Studio } from "../studio";

/** Stops the animations of the model's tools, so that the link, the picture and the files show the same plant. */
export function restTools(studio: Studio): void {
	for (const tool of studio.state.modelUi?.tools ?? []) tool.rest?.(studio);
}
