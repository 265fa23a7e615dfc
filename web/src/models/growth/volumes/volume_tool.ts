/** Tools of growth volumes: glass shells and handles in the 3-D view. Edits are written into the text. */

import { svg } from "lit";
import type { Change, EditorContext } from "../../../ui/editor_context";
import { LazyInteraction } from "../../../ui/handles/lazy_interaction";
import { createShellTool } from "../../../ui/shell_tool";
import type { Tool } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import { text as message } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { fetchedText } from "../texts";
import { withVolumes, writtenVolumes } from "./footprint";
import { type GrowthVolume, surfaceOf } from "./volume";

export type VolumeContext = EditorContext<GrowthSpecimen, GrowthPlant>;

/** Tool state of growth volumes. */
export interface VolumeState {
	/** Whether handles are shown. */
	readonly handles: boolean;
	/** Volume whose height, lean and widths are shown. */
	readonly chosen: number;
}

const GLASS = svg`<path d="M6.500 4h7M4 16.500h12M6.500 4L4 16.500M13.500 4L16 16.500" stroke-dasharray="2 1.500"/>`;
const HANDLES = svg`<path d="M6.500 4h7L16 16.500H4z"/><circle cx="10" cy="4" r="1.600" fill="currentcolor"/><circle cx="16" cy="16.500" r="1.600" fill="currentcolor"/><circle cx="4" cy="16.500" r="1.600" fill="currentcolor"/>`;

/** Returns the volumes written in the text; if the text computes any, those of the last plant. */
export function volumesOf(specimen: GrowthSpecimen, grown: GrowthPlant | undefined): readonly GrowthVolume[] {
	const text = fetchedText(specimen);
	return (text === undefined ? undefined : writtenVolumes(text)) ?? grown?.volumes ?? [];
}

/** Returns the change that writes volumes into the text; a preset's text becomes the plant's own. */
export function put(specimen: GrowthSpecimen, volumes: readonly GrowthVolume[]): Change {
	const text = fetchedText(specimen);
	return text === undefined ? {} : { details: { grammar: withVolumes(text, volumes) } };
}

const volumeGlass = createShellTool<GrowthSpecimen, GrowthPlant>({
	name: "glass",
	icon: GLASS,
	get label() {
		return message("glass");
	},
	initial: true,
	get fetchFailedMessage() {
		return message("glass_failed");
	},
	ofPlant: true,
	renderer: async () => new (await import("../../../render/shell_renderer")).ShellRenderer(),
	shells: (specimen, grown) => volumesOf(specimen, grown).map(surfaceOf),
});

/** The tool that shows and drags the growth volumes. */
export const volumeTool: Tool<GrowthSpecimen, GrowthPlant, VolumeState> = {
	name: "volumes",
	initial: { handles: true, chosen: 0 },
	press: (context) => {
		const state = context.toolState(volumeTool);
		context.setToolState(volumeTool, { ...state, handles: !state.handles });
	},
	button: {
		slot: "edit",
		icon: HANDLES,
		get label() {
			return message("handles");
		},
		pressed: (context) => context.toolState(volumeTool).handles,
	},
	key: {
		letter: "a",
		get description() {
			return message("handles_key");
		},
	},
	keys: [
		{
			get keys() {
				return [message("arrow_keys")];
			},
			get description() {
				return message("key_arrows");
			},
		},
		{
			keys: ["Delete"],
			get description() {
				return message("key_delete");
			},
		},
		{
			keys: ["Page Up", "Page Down"],
			get description() {
				return message("key_page");
			},
		},
	],
	interaction: (view, context) =>
		new LazyInteraction({
			context,
			wanted: () => context.toolState(volumeTool).handles,
			fetch: async () => new (await import("./volume_interaction")).VolumeInteraction(view, context),
			onFetchFailed: () => context.setToolState(volumeTool, { ...context.toolState(volumeTool), handles: false }),
		}),
};

export const volumeTools: readonly Tool<GrowthSpecimen, GrowthPlant>[] = [
	volumeGlass as Tool<GrowthSpecimen, GrowthPlant>,
	volumeTool as Tool<GrowthSpecimen, GrowthPlant>,
];
