/** Draws the derivation in the 3-D view: the step's plant, highlighted modules and the module under the pointer. */
import type { DrawnGeometry } from "../plant/drawn";
import type { Plant } from "../plant/plant";
import { castRay } from "../plant/sighting";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, EditorState } from "../ui/editor_context";
import type { PointerRay } from "../ui/handles/handle_ways";
import { PickPointer } from "../ui/pick_pointer";
import type { ToolInteraction, ToolView } from "../ui/tool";
import { DERIVATION, type DerivationSource, type DerivedScene, type LitDrawing } from "./derivation_tool";
import { drawnBy, drawnIn } from "./lit_parts";

/** Tolerance for pointing at a thin segment, and least radius of its highlight, in CSS pixels. */
const MISSED = 6;
const THIN = 1.2;
/** CSS custom property of the highlight colour. */
const COLOUR = "--lit";

export class DerivationInteraction<S extends Specimen, G extends Plant> implements ToolInteraction<S, G> {
	readonly #view: ToolView;
	readonly #context: EditorContext<S, G>;
	readonly #source: DerivationSource<S, G>;
	readonly #pointer: PickPointer;
	#renderer: LitDrawing | undefined;
	#disposed = false;
	#drawn: { readonly of: Plant; readonly drawn: DrawnGeometry } | undefined;
	/** Inputs of the last highlight, to detect changes. */
	#highlightInputs: readonly unknown[] = [];

	/** @param source loads the renderer of highlights, and finds the modules of a plant */
	constructor(view: ToolView, context: EditorContext<S, G>, source: DerivationSource<S, G>) {
		this.#view = view;
		this.#context = context;
		this.#source = source;
		this.#pointer = new PickPointer(view, {
			name: "choosing",
			at: (x, y) => this.#moduleAt(x, y),
			mark: (module) => this.#setMet(module, false),
			take: (module) => this.#setMet(module, true),
		});
		void source.renderer().then(
			(renderer) => {
				if (this.#disposed) return;
				this.#renderer = renderer;
				view.addOverlay(renderer.object);
				this.update(context.state);
			},
			() => {}, // Without the renderer nothing is highlighted, but pointed modules are still marked in the string.
		);
	}

	/**
	 * Follows the page's state: shows the plant of the chosen step in place of the document's, and highlights the shapes that the
	 * chosen modules drew.
	 */
	update({ grownFrom, dark }: EditorState<S, G>): void {
		const { open, scene, lit } = this.#context.toolState(DERIVATION);
		// The substitute of an edited text stays until the next plant has grown.
		this.#view.showSubstitute(scene?.instead ? scene : undefined);
		const current = scene?.from === grownFrom ? scene : undefined;
		this.#pointer.enabled = open && current !== undefined && !this.#source.taken?.(this.#context);
		const shines = [current, lit, dark];
		if (!this.#renderer || shines.every((each, index) => each === this.#highlightInputs[index])) return;
		this.#highlightInputs = shines;
		this.#showHighlight(this.#renderer, current, lit ? drawnBy(lit, current) : { segments: [], organs: [] });
	}

	/** Removes the highlight and shows the document's plant again. */
	dispose(): void {
		this.#disposed = true;
		this.#pointer.dispose();
		this.#view.showSubstitute(undefined);
		if (!this.#renderer) return;
		this.#view.removeOverlay(this.#renderer.object);
		this.#renderer.dispose();
	}

	/** Highlights segments and organs, given by their indices in the scene's plant. */
	#showHighlight(
		renderer: LitDrawing,
		scene: DerivedScene | undefined,
		{ segments, organs }: { readonly segments: readonly number[]; readonly organs: readonly number[] },
	): void {
		renderer.object.visible = scene !== undefined && segments.length + organs.length > 0;
		if (scene && renderer.object.visible) {
			const drawn = this.#drawnOf(scene);
			const colour = getComputedStyle(this.#view.canvas).getPropertyValue(COLOUR).trim() || "orange";
			renderer.show(drawn, segments, organs, this.#thinnest(drawn), colour);
		}
		this.#view.requestRender();
	}

	/**
	 * Returns the index of the module that drew the part under a point of the canvas, in CSS pixels; undefined if there
	 * is none. Segments count as hit within `MISSED` pixels.
	 */
	#moduleAt(x: number, y: number): number | undefined {
		const { scene } = this.#context.toolState(DERIVATION);
		if (!scene) return undefined;
		const sight = this.#view.rayThrough(x, y);
		const met = castRay(this.#drawnOf(scene), sight, MISSED * apart(sight, this.#view.rayThrough(x + 1, y)));
		return met && drawnIn(scene, met);
	}

	/**
	 * Stores the module under the pointer, or the clicked one, in the tool's state.
	 * @param chosen whether the module was clicked
	 */
	#setMet(module: number | undefined, chosen: boolean): void {
		const state = this.#context.toolState(DERIVATION);
		const { met, scene } = state;
		if (met?.module === module && met?.chosen === chosen) return;
		const next = module === undefined || !scene ? undefined : { module, step: scene.step, chosen };
		this.#context.setToolState(DERIVATION, { ...state, met: next });
	}

	/** Returns the drawn segments and organs of the scene's plant, computed once per plant. */
	#drawnOf({ grown }: DerivedScene): DrawnGeometry {
		if (this.#drawn?.of !== grown) this.#drawn = { of: grown, drawn: this.#source.drawn(grown as G) };
		return this.#drawn.drawn;
	}

	/** Returns the radius, in metres, that covers `THIN` CSS pixels at the plant's distance from the eye. */
	#thinnest({ ends }: DrawnGeometry): number {
		const { clientWidth, clientHeight } = this.#view.canvas;
		const [x, y] = [clientWidth / 2, clientHeight / 2];
		const sight = this.#view.rayThrough(x, y);
		const away = Math.hypot(...sight.origin.map((each, k) => each - (ends[k] ?? 0)));
		return THIN * away * apart(sight, this.#view.rayThrough(x + 1, y));
	}
}

/** Returns the angle between two nearby rays in radians, as the distance of their unit vectors. */
function apart(a: PointerRay, b: PointerRay): number {
	const [first, second] = [a, b].map(({ direction }) => {
		const length = Math.hypot(...direction);
		return direction.map((each) => each / length);
	});
	return Math.hypot(...first.map((each, k) => each - second[k]));
}
