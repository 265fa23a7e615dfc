/** The title of a plant, on the page and in the tab. */

import type { PageModel } from "../models/page_model";
import { withParameters } from "../specimen/edit";
import { fromPreset } from "../specimen/from_preset";
import { growsAlike } from "../specimen/same";
import type { Specimen } from "../specimen/specimen";
import type { Tool } from "../ui/tool";
import { text } from "./messages.generated";
import { runningBy } from "./panel_groups";

/**
 * Returns "Maple", or "Maple (edited)"; the model's own title where it has one.
 * @param tools of the model
 */
export function titleOf(specimen: Specimen, model: PageModel, tools: readonly Tool[] = []): string {
	const own = model.titled?.(specimen);
	if (own !== undefined) return own;
	const title = model.presets.named(specimen.preset)?.title ?? model.title;
	return isAltered(specimen, model, tools) ? text("title_edited", { title }) : title;
}

/**
 * Returns whether the shape differs from the preset's. The seed and parameters that a tool's bar animates do not count.
 */
export function isAltered(specimen: Specimen, model: PageModel, tools: readonly Tool[] = []): boolean {
	const preset = presetOf(model, specimen.preset);
	const values = Object.fromEntries(runningBy(tools).map((key) => [key, preset.parameters[key]]));
	// An unknown preset name means the first preset.
	const named = { ...specimen, seed: preset.seed, preset: preset.preset };
	return !growsAlike(withParameters(model, named, values), preset);
}

/** The last preset, cached: a playing life needs it at every frame. */
let known: { model: PageModel; name: string; preset: Specimen } | undefined;

/** Returns the specimen of a preset; the last one is cached. */
function presetOf(model: PageModel, name: string): Specimen {
	if (known?.model !== model || known.name !== name) known = { model, name, preset: fromPreset(model, name) };
	return known.preset;
}
