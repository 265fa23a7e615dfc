/** The handles of growth volumes over the 3-D view. */
import type { DeskState } from "../../../ui/desk";
import { PlantHands } from "../../../ui/handles/plant_hands";
import type { ToolHands, ToolView } from "../../../ui/tool";
import type { GrowthPlant } from "../growth_plant";
import type { GrowthSpecimen } from "../specimen";
import { volumeHandles } from "./volume_handles";
import { put, type VolumeDesk, volumesOf, volumeTool } from "./volume_tool";

export class VolumeHands implements ToolHands<GrowthSpecimen, GrowthPlant> {
	readonly #desk: VolumeDesk;
	readonly #handles: PlantHands<GrowthSpecimen, GrowthPlant>;

	constructor(view: ToolView, desk: VolumeDesk) {
		this.#desk = desk;
		this.#handles = new PlantHands<GrowthSpecimen, GrowthPlant>(view, desk, {
			kept: ({ grammar }) => ({ grammar }),
			focused: (id) => this.#focused(id),
		});
	}

	update({ specimen, grown }: DeskState<GrowthSpecimen, GrowthPlant>): void {
		const { handles, chosen } = this.#desk.toolState(volumeTool);
		const volumes = volumesOf(specimen, grown);
		const shown = handles && volumes.length > 0;
		this.#handles.lay(
			shown
				? volumeHandles(volumes, Math.min(chosen, volumes.length - 1), (changed) => put(specimen, changed))
				: undefined,
		);
	}

	dispose(): void {
		this.#handles.dispose();
	}

	#focused(id: string): void {
		const [, volume] = /^volume-(\d+)$/.exec(id) ?? [];
		const state = this.#desk.toolState(volumeTool);
		if (volume !== undefined && Number(volume) !== state.chosen)
			this.#desk.setToolState(volumeTool, { ...state, chosen: Number(volume) });
	}
}
