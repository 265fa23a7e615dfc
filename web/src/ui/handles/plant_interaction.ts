/**
 * Interaction of tools with a model's handles over the 3-D view: sets the handles of each document, and restores the
 * document when a drag is cancelled.
 */
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";
import type { Change, EditorContext } from "../editor_context";
import type { ToolView } from "../tool";
import type { PlantHandles } from "./plant_handle";
import { PlantHandleLayer } from "./plant_handle_layer";

/** Class of the canvas while handles are on it: the picture then does not fade at its edge (style/stage.css). */
const WHOLE_SURFACE = "handles";

export interface PlantInteractionOptions<S extends Specimen> {
	/** Returns the details of a document that handles edit; a cancelled drag restores them. */
	editedDetails(specimen: S): NonNullable<Change["details"]>;
	/** Called when a handle gets the focus. */
	focused?(id: string): void;
}

export class PlantInteraction<S extends Specimen, G extends Plant> {
	readonly #view: ToolView;
	readonly #layer: PlantHandleLayer;
	readonly #undraw: () => void;

	/** @param options.editedDetails returns the details that handles change: restored when a drag is cancelled */
	constructor(view: ToolView, context: EditorContext<S, G>, { editedDetails, focused }: PlantInteractionOptions<S>) {
		this.#view = view;
		let before: NonNullable<Change["details"]> = {};
		this.#layer = new PlantHandleLayer({
			canvas: view.canvas,
			project: (at) => view.project(at),
			rayThrough: (x, y) => view.rayThrough(x, y),
			begin: () => {
				before = editedDetails(context.state.specimen);
			},
			change: (change) => context.edit(change),
			settle: () => context.settle(),
			cancel: () => {
				context.edit({ details: before });
				context.settle();
			},
			...(focused ? { focused } : {}),
		});
		this.#undraw = view.onDrawn(() => this.#layer.place());
	}

	/** Replaces the handles; undefined removes all. */
	set(handles: PlantHandles | undefined, wholeSurface = handles !== undefined): void {
		this.#view.canvas.classList.toggle(WHOLE_SURFACE, wholeSurface);
		this.#layer.set(handles);
		this.#view.requestRender();
	}

	/** Removes the handles. */
	dispose(): void {
		this.#view.canvas.classList.remove(WHOLE_SURFACE);
		this.#undraw();
		this.#layer.dispose();
	}
}
