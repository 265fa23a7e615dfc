/**
 * Tool to select a volume by clicking it: shows its numbers, and those of the text, which can be edited (Petrenko
 * 2014, section 3.4).
 */

import { html } from "lit";
import type { EditorContext } from "../../../ui/editor_context";
import { PickPointer } from "../../../ui/pick_pointer";
import type { Tool } from "../../../ui/tool";
import type { FlowerPlant } from "../flower_plant";
import { text as message } from "../messages.generated";
import type { FlowerSpecimen } from "../specimen";
import { type ChosenVolume, chosenOf, stillChosen } from "./chosen_volume";
import { organOf, type VolumeOrgan } from "./organ";
import "./volume_panel";

export type FlowerContext = EditorContext<FlowerSpecimen, FlowerPlant>;

const VOLUME = {
	key: "volume",
	get title() {
		return message("volume");
	},
	get help() {
		return message("volume_help");
	},
} as const;

/** The chosen volume, and the preset of its flower, since it does not apply to other presets. */
interface Choice {
	readonly volume: ChosenVolume;
	readonly preset: string;
}

export const volumeTool: Tool<FlowerSpecimen, FlowerPlant, Choice | undefined> = {
	name: "volume",
	initial: undefined,
	panel: {
		group: VOLUME,
		place: "below",
		subject: chosenIn,
		draw: (context) =>
			html`<panicle-volume .context=${context} .choose=${(volume: number | undefined) => choose(context, volume)} .chosenIn=${chosenIn}></panicle-volume>`,
	},
	/** Selects a volume by a click, and marks the organ that it belongs to. */
	interaction: (view, context) => {
		const pointer = new PickPointer(view, {
			name: "picking-volume",
			at: (x, y) => view.pick(x, y),
			// Picking is too slow for hovering, with so many triangles.
			hovers: false,
			mark: () => {},
			take: (volume) => choose(context, volume),
		});
		pointer.enabled = true;
		return {
			update: () => {
				const chosen = chosenIn(context);
				view.mark(chosen, chosen === undefined ? undefined : organIn(context, chosen)?.volumes);
			},
			dispose: () => pointer.dispose(),
		};
	},
};

/** The last result of `organIn`, which runs at every change of the state. */
let lastOrgan: { readonly grown: FlowerPlant; readonly chosen: number; readonly organ: VolumeOrgan } | undefined;

/** Returns the organ of a volume, computed once per plant and choice. */
function organIn({ state: { grown } }: FlowerContext, chosen: number): VolumeOrgan | undefined {
	if (!grown) return undefined;
	if (lastOrgan?.grown !== grown || lastOrgan.chosen !== chosen)
		lastOrgan = { grown, chosen, organ: organOf(grown.volumes, chosen) };
	return lastOrgan.organ;
}

/**
 * Returns the number of the chosen volume in the present plant; undefined if none is chosen, or it no longer exists.
 */
export function chosenIn(context: FlowerContext): number | undefined {
	const choice = context.toolState(volumeTool);
	return choice?.preset === context.state.specimen.preset ? stillChosen(context.state.grown, choice.volume) : undefined;
}

/** Chooses the volume of a number in the present plant; undefined chooses none. */
export function choose(context: FlowerContext, chosen: number | undefined): void {
	const volume = chosenOf(context.state.grown, chosen);
	context.setToolState(volumeTool, volume && { volume, preset: context.state.specimen.preset });
}
