/** Maps modules of a string to the parts of a plant that they drew, and to modules of other strings. */
import type { DerivationTrace, ModuleSpan, TraceEntry } from "../plant/derivation_trace";
import { NOT_DRAWN } from "../plant/derivation_trace";
import type { RayHit } from "../plant/sighting";
import type { DerivedScene } from "./derivation_tool";

type Marks = Pick<DerivedScene, "segments" | "organs">;

/** Returns the indices of segments and organs that modules drew. */
export function drawnBy(
	{ first, count }: ModuleSpan,
	scene: Marks | undefined,
): { segments: number[]; organs: number[] } {
	const within = (modules: Uint32Array) => {
		const found: number[] = [];
		for (let index = 0; index < modules.length; index++) {
			const module = modules[index];
			if (module >= first && module - first < count) found.push(index);
		}
		return found;
	};
	return scene ? { segments: within(scene.segments), organs: within(scene.organs) } : { segments: [], organs: [] };
}

/** Returns the module that drew a part; undefined if the text did not draw it. */
export function drawnIn({ segments, organs }: Marks, { segment, organ }: RayHit): number | undefined {
	const module = segment === undefined ? organs[organ ?? -1] : segments[segment];
	return module === NOT_DRAWN ? undefined : module;
}

/**
 * Returns the modules to highlight in the view for a module of the traced step: the module itself if the view shows
 * that step, its descendants if the view shows the last step, else undefined.
 */
export function litBy(
	index: number,
	module: Pick<TraceEntry, "last">,
	{ step, counts }: Pick<DerivationTrace, "step" | "counts">,
	scene: Pick<DerivedScene, "step"> | undefined,
): ModuleSpan | undefined {
	if (scene?.step === step) return { first: index, count: 1 };
	return scene?.step === counts.length - 1 ? module.last : undefined;
}
