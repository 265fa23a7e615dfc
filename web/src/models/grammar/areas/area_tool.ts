/** Tools of growth areas: glass shells and handles in the 3-D view. */

import { svg } from "lit";
import type { EditorContext } from "../../../ui/editor_context";
import { LazyInteraction } from "../../../ui/handles/lazy_interaction";
import { sameDocument } from "../../../ui/same_document";
import { createShellTool } from "../../../ui/shell_tool";
import { FILE_TOPIC, type Tool } from "../../../ui/tool";
import type { GrammarPlant } from "../grammar_plant";
import { text } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";
import { bareAreas } from "../ui/warnings";
import { added } from "./area_edits";
import { surfaceOf } from "./surface";

export type AreaContext = EditorContext<GrammarSpecimen, GrammarPlant>;

/** Tool state of growth areas. */
export interface AreaState {
	/** Whether handles are shown. */
	readonly handles: boolean;
	/** Area whose sides and rotations are shown, and its numbers in the panel. */
	readonly chosen?: number | undefined;
	/** Whether the main branch's places are shown. */
	readonly path?: boolean;
	/** Content of the next stroke: the main branch's path, or a further branch. */
	readonly drawing?: "path" | "fork" | undefined;
}

const GLASS = svg`<path d="M10 3l6 3.2v7.600L10 17l-6-3.200V6.200zM4 6.200l6 3.200 6-3.200M10 9.400V17" stroke-dasharray="2 1.500"/>`;
const HANDLES = svg`<path d="M10 3l6 3.2v7.600L10 17l-6-3.200V6.200z"/><circle cx="10" cy="3" r="1.600" fill="currentcolor"/><circle cx="16" cy="13.800" r="1.600" fill="currentcolor"/><circle cx="4" cy="13.800" r="1.600" fill="currentcolor"/>`;

/** Returns whether there are areas to edit. */
export const hasAreas = ({ areas = [] }: GrammarSpecimen): boolean => areas.length > 0;

/** Translucent shells, visible by default. */
const areaGlass = createShellTool<GrammarSpecimen, GrammarPlant>({
	name: "glass",
	icon: GLASS,
	get label() {
		return text("glass");
	},
	initial: true,
	get fetchFailedMessage() {
		return text("glass_failed");
	},
	applies: hasAreas,
	renderer: async () => new (await import("../../../render/shell_renderer")).ShellRenderer(),
	shells: ({ areas = [] }) => areas.map(surfaceOf),
	marked: bareAreas,
});

/** The tool that shows, selects and draws the areas of a grammar that fills them. */
export const areaTool: Tool<GrammarSpecimen, GrammarPlant, AreaState> = {
	name: "areas",
	initial: { handles: true },
	applies: hasAreas,
	press: (context) => {
		const state = context.toolState(areaTool);
		context.setToolState(areaTool, { ...state, handles: !state.handles, drawing: undefined });
	},
	button: {
		slot: "edit",
		icon: HANDLES,
		get label() {
			return text("handles");
		},
		pressed: (context) => context.toolState(areaTool).handles,
	},
	key: {
		letter: "a",
		get description() {
			return text("handles_key");
		},
	},
	keys: [
		{
			get keys() {
				return [text("arrow_keys")];
			},
			get description() {
				return text("key_arrows");
			},
		},
		{
			keys: ["Delete"],
			get description() {
				return text("key_delete");
			},
		},
		{
			keys: ["Page Up", "Page Down"],
			get description() {
				return text("key_page");
			},
		},
	],
	interaction: (view, context) =>
		new LazyInteraction({
			context,
			wanted: ({ specimen }) => context.toolState(areaTool).handles && hasAreas(specimen),
			fetch: async () => new (await import("./area_interaction")).AreaInteraction(view, context),
			onFetchFailed: () => context.setToolState(areaTool, { handles: false }),
		}),
};

export const areaTools: readonly Tool<GrammarSpecimen, GrammarPlant>[] = [
	areaGlass as Tool<GrammarSpecimen, GrammarPlant>,
	areaTool as Tool<GrammarSpecimen, GrammarPlant>,
];

/** Adds a file's mesh as a growth area, as one undo step; reports errors to the user. */
export async function takeAreaMesh(context: AreaContext, file: File): Promise<void> {
	const isStill = sameDocument(context);
	const notify = (title: string, detail: string) => context.notify(title, [detail], { topic: FILE_TOPIC });
	const reader = await import("../../../import/mesh_file/read_in_worker").catch(() => undefined);
	if (!reader) {
		notify(text("mesh_unreadable"), text("load_failed"));
		return;
	}
	try {
		const mesh = await reader.readMeshInWorker(file);
		if (!isStill()) {
			notify(text("mesh_unused"), text("plant_changed"));
			return;
		}
		const change = added(context.state.specimen, "mesh", mesh);
		if (!change) {
			notify(text("mesh_unused"), text("areas_full"));
			return;
		}
		context.set(change);
		choose(context, (context.state.specimen.areas?.length ?? 1) - 1);
		notify(text("mesh_is_area"), text("mesh_too_big"));
	} catch (error) {
		notify(text("mesh_unreadable"), error instanceof Error ? error.message : String(error));
	}
}

/** Shows an area's handles and numbers; those of none if undefined. */
export function choose(context: AreaContext, chosen: number | undefined): void {
	context.setToolState(areaTool, { ...context.toolState(areaTool), handles: true, chosen });
}
