/** What a plant is called, on the page and in the tab. */

import type { PageModel } from "../models/page_model";
import { withParameters } from "../specimen/edit";
import { fromPreset } from "../specimen/from_preset";
import { growsAlike } from "../specimen/same";
import type { Specimen } from "../specimen/specimen";
import type { Tool } from "../ui/tool";
import { runningBy } from "./panel_groups";

/** "Maple", or "Maple, altered"; what its model calls it, where that does. @param tools the model's */
export function titleOf(specimen: Specimen, model: PageModel, tools: readonly Tool[] = []): string {
	const own = model.titled?.(specimen);
	if (own !== undefined) return own;
	const title = model.presets.named(specimen.preset)?.title ?? model.title;
	return isAltered(specimen, model, tools) ? `${title}, altered` : title;
}

/** Whether it is of another shape than its preset. Another seed is none, nor what a tool's bar runs through. */
export function isAltered(specimen: Specimen, model: PageModel, tools: readonly Tool[] = []): boolean {
	const preset = presetOf(model, specimen.preset);
	const values = Object.fromEntries(runningBy(tools).map((key) => [key, preset.parameters[key]]));
	// A name that no preset has stands for the first.
	const named = { ...specimen, seed: preset.seed, preset: preset.preset };
	return !growsAlike(withParameters(model, named, values), preset);
}

/** The last one: a life that runs asks for it at every frame. */
let known: { model: PageModel; name: string; preset: Specimen } | undefined;

function presetOf(model: PageModel, name: string): Specimen {
	if (known?.model !== model || known.name !== name) known = { model, name, preset: fromPreset(model, name) };
	return known.preset;
}
