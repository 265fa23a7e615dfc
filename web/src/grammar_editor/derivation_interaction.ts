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
	#shone: readonly unknown[] = [];

	constructor(view: ToolView, context: EditorContext<S, G>, source: DerivationSource<S, G>) {
		this.#view = view;
		this.#context = context;
		this.#source = source;
		this.#pointer = new PickPointer(view, {
			name: "choosing",
			at: (x, y) => this.#at(x, y),
			mark: (module) => this.#meet(module, false),
			take: (module) => this.#meet(module, true),
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

	update({ grownFrom, dark }: EditorState<S, G>): void {
		const { open, scene, lit } = this.#context.toolState(DERIVATION);
		// The substitute of an edited text stays until the next plant has grown.
		this.#view.showSubstitute(scene?.instead ? scene : undefined);
		const current = scene?.from === grownFrom ? scene : undefined;
		this.#pointer.enabled = open && current !== undefined && !this.#source.taken?.(this.#context);
		const shines = [current, lit, dark];
		if (!this.#renderer || shines.every((each, index) => each === this.#shone[index])) return;
		this.#shone = shines;
		this.#shine(this.#renderer, current, lit ? drawnBy(lit, current) : { segments: [], organs: [] });
	}

	dispose(): void {
		this.#disposed = true;
		this.#pointer.dispose();
		this.#view.showSubstitute(undefined);
		if (!this.#renderer) return;
		this.#view.removeOverlay(this.#renderer.object);
		this.#renderer.dispose();
	}

	#shine(
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

	#at(x: number, y: number): number | undefined {
		const { scene } = this.#context.toolState(DERIVATION);
		if (!scene) return undefined;
		const sight = this.#view.rayThrough(x, y);
		const met = castRay(this.#drawnOf(scene), sight, MISSED * apart(sight, this.#view.rayThrough(x + 1, y)));
		return met && drawnIn(scene, met);
	}

	#meet(module: number | undefined, chosen: boolean): void {
		const state = this.#context.toolState(DERIVATION);
		const { met, scene } = state;
		if (met?.module === module && met?.chosen === chosen) return;
		const next = module === undefined || !scene ? undefined : { module, step: scene.step, chosen };
		this.#context.setToolState(DERIVATION, { ...state, met: next });
	}

	#drawnOf({ grown }: DerivedScene): DrawnGeometry {
		if (this.#drawn?.of !== grown) this.#drawn = { of: grown, drawn: this.#source.drawn(grown as G) };
		return this.#drawn.drawn;
	}

	/** Returns the least visible radius at the plant's distance. */
	#thinnest({ ends }: DrawnGeometry): number {
		const { clientWidth, clientHeight } = this.#view.canvas;
		const [x, y] = [clientWidth / 2, clientHeight / 2];
		const sight = this.#view.rayThrough(x, y);
		const away = Math.hypot(...sight.origin.map((each, k) => each - (ends[k] ?? 0)));
		return THIN * away * apart(sight, this.#view.rayThrough(x + 1, y));
	}
}

/** Returns the angle between two rays, radians. */
function apart(a: PointerRay, b: PointerRay): number {
	const [first, second] = [a, b].map(({ direction }) => {
		const length = Math.hypot(...direction);
		return direction.map((each) => each / length);
	});
	return Math.hypot(...first.map((each, k) => each - second[k]));
}
