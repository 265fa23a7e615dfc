/**
 * State of the step viewer: the step, the chosen module and the plant shown in the 3-D view. Follows the plant that is
 * shown, so a text with an error leaves the state unchanged. The 3-D view reads its part from the tool's state.
 */
import { Superseded } from "../core/errors";
import { MessageError } from "../locale/message_error";
import type { DerivationTrace, TraceEntry } from "../plant/derivation_trace";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext } from "../ui/editor_context";
import { DERIVATION, type DerivationState, type DerivedScene, type MetModule } from "./derivation_tool";
import { drawnBy, litBy } from "./lit_parts";
import { text } from "./messages.generated";
import { TraceReader } from "./trace_reader";

export class Derivation {
	readonly #context: EditorContext;
	readonly #changed: () => void;
	readonly #reader = new TraceReader(() => this.#handleTrace());
	#from: Specimen | undefined;
	/** Index in the string of the step that is shown. */
	#chosen: number | undefined;
	#pointed: number | undefined;
	#met: MetModule | undefined;
	/** Specimen and step of the plant that is growing. */
	#growing: { readonly from: Specimen; readonly step: number; readonly ending: AbortController } | undefined;
	/** Specimen and step of the last plant that could not be grown. */
	#ungrown: { readonly from: Specimen; readonly step: number } | undefined;
	#closed = false;

	/** @param changed called when the displayed state has changed */
	constructor(context: EditorContext, changed: () => void) {
		this.#context = context;
		this.#changed = changed;
		this.follow();
	}

	/** The window of the trace around the requested module; undefined while none of its step is loaded. */
	get page(): DerivationTrace | undefined {
		return this.#reader.page;
	}

	/** Whether `page` belongs to an earlier plant. */
	get stale(): boolean {
		return this.#reader.stale;
	}

	/** Number of modules of each step's string; undefined until the first window is loaded. */
	get counts(): Uint32Array | undefined {
		return this.#reader.counts;
	}

	/** The step shown; undefined until the number of steps is known. */
	get step(): number | undefined {
		return this.#reader.step;
	}

	/** The last step; undefined until the number of steps is known. */
	get last(): number | undefined {
		return this.counts && this.counts.length - 1;
	}

	/** The message if no trace can be shown. */
	get fault(): string | undefined {
		return this.#reader.fault;
	}

	/** Index of the chosen module in the string of the step shown; undefined without one. */
	get chosen(): number | undefined {
		return this.#chosen;
	}

	/** Index of the module under the pointer, in the same string. */
	get pointed(): number | undefined {
		return this.#pointed;
	}

	/** Whether nothing is highlighted, because the chosen module draws no part of the plant shown. */
	get bare(): boolean {
		const { lit, scene } = this.#context.toolState(DERIVATION);
		if (!lit || !scene || this.#pointed !== undefined) return false;
		const { segments, organs } = drawnBy(lit, scene);
		return segments.length + organs.length === 0;
	}

	/** Returns the trace entry of a module of the step shown; undefined while the module is outside the window. */
	module(index: number | undefined): TraceEntry | undefined {
		return index === undefined || !this.page ? undefined : this.page.modules[index - this.page.first];
	}

	/**
	 * Updates from the editor's state: reads the trace of a new plant, and the module under the pointer in the view.
	 */
	follow(): void {
		const { grown, grownFrom } = this.#context.state;
		if (this.#closed || !grown || !grownFrom) return;
		if (grownFrom !== this.#from) {
			this.#from = grownFrom;
			this.#reader.begin(async (request, signal) => {
				const { trace } = await this.#context.growOffscreen(grownFrom, { trace: request, signal });
				if (!trace) throw new MessageError(text.message("no_derivation"));
				return trace;
			});
		}
		const { met } = this.#context.toolState(DERIVATION);
		if (met !== this.#met) {
			this.#met = met;
			this.#followPointer(met);
		}
		this.#updateScene();
	}

	/**
	 * Moves to a step, and chooses a module in it.
	 * @param chosen index of the module in that step's string
	 */
	go(step: number, chosen?: number): void {
		const last = this.last ?? step;
		const to = Math.max(0, Math.min(step, last));
		this.#chosen = chosen;
		this.#pointed = undefined;
		this.#reader.want({ step: to === last ? undefined : to, about: chosen ?? 0 });
	}

	/** Moves one step forward or back, with the chosen module: to its first child, or to its parent. */
	stepBy(by: 1 | -1): void {
		const { step = 0 } = this;
		const module = this.module(this.#chosen);
		const next = by < 0 ? module?.parent : module && module.children.count > 0 ? module.children.first : undefined;
		this.go(step + by, next);
	}

	/** Chooses the module of an index in the string shown, or none; an index beyond the string becomes the last one. */
	choose(index: number | undefined): void {
		const length = this.counts?.[this.step ?? 0] ?? 0;
		this.#chosen = index === undefined || length === 0 ? undefined : Math.max(0, Math.min(index, length - 1));
		if (this.#chosen !== undefined) this.look(this.#chosen);
		this.#highlight();
		this.#changed();
	}

	/** Loads the window around a module. */
	look(index: number): void {
		this.#reader.want({ step: this.step === this.last ? undefined : this.step, about: index });
	}

	/** Marks the module under the pointer; undefined removes the mark. */
	point(index: number | undefined): void {
		if (index === this.#pointed) return;
		this.#pointed = index;
		this.#highlight();
		this.#changed();
	}

	/**
	 * Moves to the chosen module's parent.
	 * @returns false if there is none
	 */
	up(): boolean {
		const { parent } = this.module(this.#chosen) ?? {};
		if (parent === undefined || !this.step) return false;
		this.go(this.step - 1, parent);
		return true;
	}

	/**
	 * Moves to the chosen module's first child.
	 * @returns false if the module has no children
	 */
	down(): boolean {
		const { children } = this.module(this.#chosen) ?? {};
		if (!children?.count || this.step === undefined || this.step === this.last) return false;
		this.go(this.step + 1, children.first);
		return true;
	}

	/** Whether the view shows the plant as it was after the step. */
	get follows(): boolean {
		return this.#context.toolState(DERIVATION).follows;
	}

	/** Sets whether the view shows the plant as it was after the step. */
	set follows(on: boolean) {
		this.#write({ follows: on });
		this.#updateScene();
		this.#highlight();
	}

	/** Stops, and shows the document's plant again. */
	close(): void {
		this.#closed = true;
		this.#reader.close();
		this.#growing?.ending.abort();
		this.#write({ scene: undefined, lit: undefined, met: undefined });
	}

	/** Takes new state of the reader: updates the view and reports the change. */
	#handleTrace(): void {
		if (this.fault) this.#write({ scene: undefined });
		this.#updateScene();
		this.#highlight();
		this.#changed();
	}

	/** Shows the plant of the step, or the document's plant, in the 3-D view, unless it is shown already. */
	#updateScene(): void {
		const { page, stale, step, last } = this;
		const { grown, grownFrom: from } = this.#context.state;
		if (this.#closed || !page || stale || !grown || !from || last === undefined || page.step !== step) return;
		const { scene } = this.#context.toolState(DERIVATION);
		// If no plant can be grown for the step, the last plant stays in view.
		const none = this.#ungrown?.from === from && this.#ungrown.step === page.step;
		const shown = this.follows && !none ? page.step : last;
		if (scene?.from === from && scene.step === shown) return;
		if (shown === last) this.#showWhole(page, grown, from);
		else void this.#grow(from, shown);
	}

	/**
	 * Grows the plant of a step and shows it, if it is still wanted then; one request at a time.
	 * @param from specimen of the whole plant
	 */
	async #grow(from: Specimen, step: number): Promise<void> {
		if (this.#growing?.from === from && this.#growing.step === step) return;
		this.#growing?.ending.abort();
		const growing = { from, step, ending: new AbortController() };
		this.#growing = growing;
		try {
			const { signal } = growing.ending;
			const grown: Plant = await this.#context.growOffscreen(from, {
				steps: step,
				trace: { step, count: 1 },
				meshes: true,
				signal,
			});
			if (this.#growing !== growing || this.#from !== from || this.step !== step || !this.follows) return;
			const { segments, organs } = grown.trace ?? { segments: new Uint32Array(0), organs: new Uint32Array(0) };
			this.#show({ step, grown, from, instead: true, segments, organs });
		} catch (error) {
			if (this.#growing !== growing || error instanceof Superseded) return;
			this.#ungrown = { from, step };
			this.#updateScene();
		} finally {
			if (this.#growing === growing) this.#growing = undefined;
		}
	}

	/** Shows the document's own plant. */
	#showWhole({ counts, segments, organs }: DerivationTrace, grown: Plant, from: Specimen): void {
		this.#show({ step: counts.length - 1, grown, from, instead: false, segments, organs });
	}

	/** Shows a scene in the 3-D view, without the marks of the last one. */
	#show(scene: DerivedScene): void {
		if (this.#closed) return;
		this.#write({ scene, lit: undefined, met: undefined });
		this.#highlight();
	}

	/** Highlights the pointed module in the view, or else the chosen module. */
	#highlight(): void {
		const { page } = this;
		const index = this.#pointed ?? this.#chosen;
		const module = this.module(index);
		const { scene, lit } = this.#context.toolState(DERIVATION);
		const next = page && module && index !== undefined && !this.stale ? litBy(index, module, page, scene) : undefined;
		if (lit?.first !== next?.first || lit?.count !== next?.count) this.#write({ lit: next });
	}

	/** Marks the module under the pointer in the string, and chooses the module that was clicked. */
	#followPointer(met: MetModule | undefined): void {
		const index = met && this.#ancestor(met);
		if (!met?.chosen) this.point(index);
		else if (index !== undefined) this.choose(index);
		else if (met.step === this.last) void this.#trace(met);
	}

	/**
	 * Returns the ancestor, in the step shown, of a module in the view. Undefined if the window does not contain it, or
	 * while the view still shows an intermediate step.
	 */
	#ancestor({ module, step }: MetModule): number | undefined {
		const { page } = this;
		if (step === this.step) return module;
		if (!page || step !== this.last) return undefined;
		const index = page.modules.findIndex(({ last: { first, count } }) => module >= first && module - first < count);
		return index < 0 ? undefined : page.first + index;
	}

	/**
	 * Chooses the module of the current step from which a module in the 3-D view descends; the core traces its ancestors.
	 */
	async #trace({ module }: MetModule): Promise<void> {
		const [from, step] = [this.#from, this.step];
		if (!from || step === undefined) return;
		try {
			const { trace } = await this.#context.growOffscreen(from, { trace: { step, count: 1, module } });
			const ancestor = trace?.trail?.[step];
			if (ancestor !== undefined && this.#from === from && this.step === step) this.choose(ancestor);
		} catch {
			// A newer request replaced this one.
		}
	}

	/** Changes the tool's state, which the 3-D view reads. */
	#write(change: Partial<DerivationState>): void {
		this.#context.setToolState(DERIVATION, { ...this.#context.toolState(DERIVATION), ...change });
	}
}
