/** Tool for the derivation of a plant: its state, and its interaction in the 3-D view (docs/studio.md#steps). */
import type { Object3D } from "three";
import type { ModuleSpan } from "../plant/derivation_trace";
import type { DrawnGeometry } from "../plant/drawn";
import type { Plant } from "../plant/plant";
import type { WithGrammar } from "../specimen/grammar_text";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, Stateful } from "../ui/editor_context";
import type { Tool, ToolInteraction } from "../ui/tool";
import { text } from "./messages.generated";

/** Draws the highlight; implemented by render/lit_renderer.ts. */
export interface LitDrawing {
	readonly object: Object3D;
	show(
		drawn: DrawnGeometry,
		segments: readonly number[],
		organs: readonly number[],
		thin: number,
		colour: string,
	): void;
	dispose(): void;
}

/** Describes a model for the stepper. */
export interface DerivationSource<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** Returns a plant's drawn segments and organs, in the order of its trace. */
	drawn(grown: G): DrawnGeometry;
	/** Loads the renderer of the highlight. */
	renderer(): Promise<LitDrawing>;
	/** Returns whether another tool uses the pointer. */
	taken?(context: EditorContext<S, G>): boolean;
}

/** The plant of a step's string; after the last step, the document's own plant. */
export interface DerivedScene {
	readonly step: number;
	readonly grown: Plant;
	readonly from: Specimen;
	/** Whether the plant differs from the document's. */
	readonly instead: boolean;
	/** Indices of the modules in the step's string that drew each segment, and each organ. */
	readonly segments: Uint32Array;
	readonly organs: Uint32Array;
}

/** The module under the pointer in the view. */
export interface MetModule {
	/** Index in the scene's string. */
	readonly module: number;
	readonly step: number;
	/** Whether the module was clicked. */
	readonly chosen: boolean;
}

/** State of the tool, stored until the pane closes. */
export interface DerivationState {
	readonly open: boolean;
	/** Whether the view shows the plant as it was after the step. */
	readonly follows: boolean;
	/** Plant that the view shows; undefined until the trace has the module that drew each part. */
	readonly scene?: DerivedScene | undefined;
	/** Highlighted modules of the scene's string. */
	readonly lit?: ModuleSpan | undefined;
	readonly met?: MetModule | undefined;
}

/** Derivation state, shared by all models. */
export const DERIVATION: Stateful<DerivationState> = { name: "derivation", initial: { open: false, follows: true } };

/** Returns the scene if the view shows a step's plant in place of the document's; for the caption. */
export function steppedScene<S extends Specimen, G extends Plant>(
	context: EditorContext<S, G>,
): DerivedScene | undefined {
	const { scene } = context.toolState(DERIVATION);
	return scene?.instead ? scene : undefined;
}

/** Creates the tool with the derivation's state and its interaction in the view; the grammar pane draws the rest. */
export function derivationTool<S extends Specimen & WithGrammar, G extends Plant>(
	source: DerivationSource<S, G>,
): Tool<S, G, DerivationState> {
	return {
		...DERIVATION,
		keys: [
			{
				keys: ["←", "→", "Page ↑", "Page ↓"],
				get description() {
					return text("key_modules");
				},
			},
			{
				keys: ["↑", "↓"],
				get description() {
					return text("key_parent");
				},
			},
			{
				keys: ["Enter"],
				get description() {
					return text("key_production");
				},
			},
		],
		/** Creates the interaction; its script is loaded with the first scene. */
		interaction: (view, context) => {
			let interaction: ToolInteraction<S, G> | undefined;
			let ended = false;
			let isFetching = false;
			const fetch = async () => {
				const { DerivationInteraction } = await import("./derivation_interaction");
				if (ended) return;
				interaction = new DerivationInteraction(view, context, source);
				interaction.update(context.state);
			};
			return {
				update: (state) => {
					if (interaction) interaction.update(state);
					else if (!isFetching && context.toolState(DERIVATION).scene) {
						isFetching = true;
						// If the script fails to load, the string still works; opening the pane again retries.
						fetch().catch(() => {
							isFetching = false;
						});
					}
				},
				dispose: () => {
					ended = true;
					interaction?.dispose();
				},
			};
		},
	};
}
