/** The model's handles over the picture of its plant. */

import { fromPreset } from "../../specimen/from_preset";
import type { Specimen } from "../../specimen/specimen";
import { apply } from "../../ui/change";
import type { Change } from "../../ui/editor_context";
import type { HandlesOf } from "../../ui/handles/plant_handle";
import { PlantHandleLayer } from "../../ui/handles/plant_handle_layer";
import type { GrownDocument } from "../grown_detail";
import type { SpecimenView } from "../specimen_view";
import type { Extra, ExtrasHost } from "./extras";

export class HandlesLayer implements Extra {
	readonly #host: ExtrasHost;
	readonly #layer: PlantHandleLayer;
	readonly #stopFollowingDraws: () => void;
	#shown: GrownDocument | undefined;
	/** The handles of the model shown; undefined if it has none. */
	#handlesOf: HandlesOf<Specimen> | undefined;
	/** Whether the model's handles could not be fetched: the next plant tries again. */
	#fetchFailed = false;
	/** The specimen as the handles show it; during a drag ahead of the plant. */
	#specimen: Specimen | undefined;
	/** The specimen before the drag, which Escape restores. */
	#before: Specimen | undefined;
	#disposed = false;

	/** Creates the layer over the element's canvas; a cancelled drag restores the specimen from before it. */
	constructor(host: ExtrasHost, view: SpecimenView) {
		this.#host = host;
		this.#layer = new PlantHandleLayer({
			canvas: host.root.querySelector("canvas") as HTMLCanvasElement,
			project: (at) => view.project(at),
			rayThrough: (x, y) => view.rayThrough(x, y),
			begin: () => {
				this.#before = this.#specimen;
			},
			change: (change) => this.#change(change),
			settle: () => this.#host.interaction.settle(),
			cancel: () => this.#cancel(),
		});
		this.#stopFollowingDraws = view.onDrawn(() => this.#layer.place());
	}

	/** Follows a grown plant: sets its handles, unless one is being dragged. */
	show(shown: GrownDocument): void {
		const another = shown.model !== this.#shown?.model;
		this.#shown = shown;
		if (another || this.#fetchFailed) void this.#use(shown);
		else if (!this.#layer.held) this.#setHandles(shown.specimen);
	}

	/** Removes the handles. */
	dispose(): void {
		this.#disposed = true;
		this.#stopFollowingDraws();
		this.#layer.dispose();
	}

	/** Loads the handles of another model, and shows those of the plant in view then. */
	async #use({ model }: GrownDocument): Promise<void> {
		this.#layer.cancel();
		this.#handlesOf = undefined;
		this.#setHandles(undefined);
		this.#fetchFailed = false;
		const handlesOf = await model.handles?.().catch(() => {
			this.#fetchFailed = this.#shown?.model === model;
			return undefined;
		});
		if (this.#disposed || this.#shown?.model !== model) return;
		this.#handlesOf = handlesOf;
		this.#setHandles(this.#shown.specimen);
	}

	/** Places the handles of a specimen. */
	#setHandles(specimen: Specimen | undefined): void {
		const { model } = this.#shown ?? {};
		this.#specimen = specimen;
		this.#layer.set(specimen && model && this.#handlesOf?.(specimen, fromPreset(model, specimen.preset)));
	}

	/** Applies a change by a handle: the handles move at once, the plant follows. */
	#change(change: Change): void {
		const { model } = this.#shown ?? {};
		if (!model || !this.#specimen) return;
		this.#setHandles(apply(model, this.#specimen, change));
		this.#host.interaction.edit((now) => (now.model === model.name ? apply(model, now, change) : now));
	}

	/** Restores the specimen from before the drag. */
	#cancel(): void {
		const before = this.#before;
		if (!before) return;
		this.#setHandles(before);
		this.#host.interaction.edit(() => before);
		this.#host.interaction.settle();
	}
}
