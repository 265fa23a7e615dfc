/** The handles of growth volumes over the 3-D view. */
import type { EditorState } from "../../../ui/editor_context";
import { PlantInteraction } from "../../../ui/handles/plant_interaction";
import type { ToolInteraction, ToolView } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import type { GrowthSpecimen } from "../specimen";
import { volumeHandles } from "./volume_handles";
import { put, type VolumeContext, volumesOf, volumeTool } from "./volume_tool";

export class VolumeInteraction implements ToolInteraction<GrowthSpecimen, GrowthPlant> {
	readonly #context: VolumeContext;
	readonly #handles: PlantInteraction<GrowthSpecimen, GrowthPlant>;

	constructor(view: ToolView, context: VolumeContext) {
		this.#context = context;
		this.#handles = new PlantInteraction<GrowthSpecimen, GrowthPlant>(view, context, {
			editedDetails: ({ grammar }) => ({ grammar }),
			focused: (id) => this.#chooseFocused(id),
		});
	}

	/** Shows the handles while the tool is on; a specimen without volumes of its own shows those of the grown plant. */
	update({ specimen, grown }: EditorState<GrowthSpecimen, GrowthPlant>): void {
		const { handles, chosen } = this.#context.toolState(volumeTool);
		const volumes = volumesOf(specimen, grown);
		const shown = handles && volumes.length > 0;
		this.#handles.set(
			shown
				? volumeHandles(volumes, Math.min(chosen, volumes.length - 1), (changed) => put(specimen, changed))
				: undefined,
		);
	}

	/** Removes the handles. */
	dispose(): void {
		this.#handles.dispose();
	}

	/** Chooses the volume whose handle gets the focus. */
	#chooseFocused(id: string): void {
		const [, volume] = /^volume-(\d+)$/.exec(id) ?? [];
		const state = this.#context.toolState(volumeTool);
		if (volume !== undefined && Number(volume) !== state.chosen)
			this.#context.setToolState(volumeTool, { ...state, chosen: Number(volume) });
	}
}
