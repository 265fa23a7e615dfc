/** Tool that shows bounding shells of a plant faintly in the 3-D view, for any model. */
import type { SVGTemplateResult } from "lit";
import type { Object3D } from "three";
import type { Plant } from "../plant/plant";
import type { ClosedMesh } from "../specimen/closed_mesh";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext, EditorState } from "./editor_context";
import { text } from "./messages.generated";
import type { Tool, ToolInteraction, ToolView } from "./tool";

/** Draws the shells; implemented by render/shell_renderer.ts. */
export interface ShellDrawing {
	readonly object: Object3D;
	/** @param colour any CSS colour */
	show(shells: readonly ClosedMesh[], colour: string): void;
	/** Gives some of the shells, counted from 0, another colour, with more contrast. */
	mark(marked: ReadonlySet<number>, colour: string): void;
	dispose(): void;
}

export interface ShellToolOptions<S extends Specimen, G extends Plant = Plant> {
	/** Name of the tool. */
	readonly name: string;
	readonly icon: SVGTemplateResult;
	readonly label: string;
	/** Whether shells are shown at first; the default is no. */
	readonly initial?: boolean;
	/** Notice if the renderer fails to load. */
	readonly fetchFailedMessage: string;
	/** Loads the renderer. */
	renderer(): Promise<ShellDrawing>;
	/**
	 * Returns the shells in the plant's metres.
	 * @param grown the last plant, if shells depend on it
	 */
	shells(specimen: S, grown: G | undefined): readonly ClosedMesh[];
	/** Whether shells also depend on the last plant; the default is no. */
	ofPlant?: true;
	/** Returns the indices of shells that the last plant marks; the default is none. */
	marked?(grown: G): ReadonlySet<number>;
	/** Returns whether the tool applies to a specimen; the default is yes. */
	applies?(specimen: S): boolean;
}

/** Creates a tool whose button shows or hides closed surfaces (shells) beside the plant. */
export function createShellTool<S extends Specimen, G extends Plant>(
	options: ShellToolOptions<S, G>,
): Tool<S, G, boolean> {
	const { name, icon, label, initial = false, applies } = options;
	const tool: Tool<S, G, boolean> = {
		name,
		initial,
		...(applies ? { applies } : {}),
		press: (context) => context.setToolState(tool, !context.toolState(tool)),
		button: { slot: "view", icon, label, pressed: (context) => context.toolState(tool) },
		interaction: (view, context) => new ShellInteraction(view, context, options, tool),
	};
	return tool;
}

class ShellInteraction<S extends Specimen, G extends Plant> implements ToolInteraction<S, G> {
	readonly #view: ToolView;
	readonly #context: EditorContext<S, G>;
	readonly #options: ShellToolOptions<S, G>;
	readonly #tool: Tool<S, G, boolean>;
	/** Loaded on first use. */
	#renderer: Promise<ShellDrawing | undefined> | undefined;
	#shown: { readonly specimen: S; readonly dark: boolean; readonly grown: G | undefined } | undefined;
	#disposed = false;

	/** @param tool its state is whether shells are shown */
	constructor(
		view: ToolView,
		context: EditorContext<S, G>,
		options: ShellToolOptions<S, G>,
		tool: Tool<S, G, boolean>,
	) {
		this.#view = view;
		this.#context = context;
		this.#options = options;
		this.#tool = tool;
	}

	/** Draws the shells of the current state, once the renderer is loaded; it is loaded on first use. */
	update(): void {
		if (!this.#visible(this.#context.state.specimen) && !this.#renderer) return;
		this.#renderer ??= this.#fetch();
		void this.#renderer.then((renderer) => {
			if (renderer && !this.#disposed) this.#show(renderer, this.#context.state);
		});
	}

	/** Removes the shells and frees the renderer. */
	dispose(): void {
		this.#disposed = true;
		void this.#renderer?.then((renderer) => {
			if (!renderer) return;
			this.#view.removeOverlay(renderer.object);
			renderer.dispose();
		});
	}

	/** Returns whether the tool is switched on and applies to a specimen. */
	#visible(specimen: S): boolean {
		return this.#context.toolState(this.#tool) && (this.#options.applies?.(specimen) ?? true);
	}

	/**
	 * Updates the drawing only where needed: shells by specimen (or plant, with `ofPlant`) and colours, marks by plant.
	 */
	#show(renderer: ShellDrawing, { specimen, dark, grown }: EditorState<S, G>): void {
		const visible = this.#visible(specimen);
		const { marked, ofPlant = false } = this.#options;
		const another = this.#shown?.grown !== grown;
		const same = this.#shown?.specimen === specimen && this.#shown.dark === dark && !(ofPlant && another);
		const alike = same && !(marked && another);
		if (visible === renderer.object.visible && (alike || !visible)) return;
		renderer.object.visible = visible;
		if (visible && !alike) {
			const style = getComputedStyle(this.#view.canvas);
			if (!same) renderer.show(this.#options.shells(specimen, grown), style.color);
			if (marked && grown) renderer.mark(marked(grown), style.accentColor);
			this.#shown = { specimen, dark, grown };
		}
		this.#view.requestRender();
	}

	/** Loads the renderer. If its script fails to load, the tool is switched off, and pressing its button retries. */
	async #fetch(): Promise<ShellDrawing | undefined> {
		const renderer = await this.#options.renderer().catch(() => undefined);
		if (!renderer) {
			this.#renderer = undefined;
			this.#context.setToolState(this.#tool, false);
			this.#context.notify(this.#options.fetchFailedMessage, [text("press_again")]);
			return undefined;
		}
		renderer.object.visible = false;
		this.#view.addOverlay(renderer.object);
		return renderer;
	}
}
