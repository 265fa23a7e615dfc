import type { ToolInteraction, ToolView } from "../../../ui/tool";
import type { BunchPlant } from "../bunch_plant";
import { text } from "../messages.generated";
import type { OctahedronHandles } from "../profile/octahedron";
import type { OctahedronColours } from "../profile/octahedron_renderer";
import type { BunchSpecimen } from "../specimen";
import type { BunchContext, BunchState, BunchTool } from "./context";
import { OCTAHEDRON } from "./icons";
import { sides } from "./sides";

/** Tool: the profile in the 3-D view, with its handles. */
export const octahedron: BunchTool<boolean> = {
	name: "octahedron",
	initial: false,
	press: (context) => context.setToolState(octahedron, !context.toolState(octahedron)),
	button: {
		slot: "edit",
		icon: OCTAHEDRON,
		get label() {
			return text("octahedron");
		},
		pressed: (context) => context.toolState(octahedron),
	},
	key: {
		letter: "o",
		get description() {
			return text("octahedron_key");
		},
	},
	interaction: (view, context) => new OctahedronInteraction(view, context),
};

/** Class of a canvas that must not be cropped, since outline or handles may be near its edge: style/stage.css. */
const WHOLE_SURFACE = "handles";

class OctahedronInteraction implements ToolInteraction<BunchSpecimen, BunchPlant> {
	readonly #view: ToolView;
	readonly #context: BunchContext;
	/** Handles, loaded on first use. */
	#handles: Promise<OctahedronHandles | undefined> | undefined;
	#dark: boolean | undefined;
	#disposed = false;

	constructor(view: ToolView, context: BunchContext) {
		this.#view = view;
		this.#context = context;
	}

	/** Shows or hides the handles; loads them at the first use. */
	update(state: BunchState): void {
		const shown = this.#context.toolState(octahedron);
		this.#view.canvas.classList.toggle(WHOLE_SURFACE, shown);
		if (!shown && !this.#handles) return;
		this.#handles ??= this.#fetch();
		void this.#handles.then((handles) => {
			if (handles && !this.#disposed) this.#updateHandles(handles, state);
		});
	}

	/** Removes the handles from the view. */
	dispose(): void {
		this.#disposed = true;
		this.#view.canvas.classList.remove(WHOLE_SURFACE);
		void this.#handles?.then((handles) => {
			if (!handles) return;
			this.#view.removeOverlay(handles.object);
			handles.dispose();
		});
	}

	/** Brings the loaded handles up to date with tool state, theme and parameters. */
	#updateHandles(handles: OctahedronHandles, { dark }: BunchState): void {
		const shown = this.#context.toolState(octahedron);
		if (dark !== this.#dark) handles.setColours(coloursOf(this.#view.canvas));
		this.#dark = dark;
		handles.setVisible(shown);
		if (shown) handles.update(this.#context.state.specimen.parameters);
	}

	/** Loads the handles; on failure the tool turns off, and the next press retries. */
	async #fetch(): Promise<OctahedronHandles | undefined> {
		try {
			return await this.#create();
		} catch {
			this.#handles = undefined;
			if (this.#disposed) return undefined;
			this.#context.setToolState(octahedron, false);
			this.#context.notify(text("octahedron_failed"), [text("octahedron_retry")]);
			return undefined;
		}
	}

	/** Loads the handles and adds them to the view. */
	async #create(): Promise<OctahedronHandles> {
		const { OctahedronHandles } = await import("../profile/octahedron");
		const view = this.#view;
		const handles = new OctahedronHandles({
			canvas: view.canvas,
			camera: view.camera,
			requestRender: () => view.requestRender(),
			setControlsEnabled: (on) => {
				view.orbiting = on;
			},
			locks: () => this.#context.toolState(sides),
			input: (parameters) => this.#context.edit({ parameters }),
			change: () => this.#context.settle(),
		});
		view.addOverlay(handles.object);
		return handles;
	}
}

/** Reads the handles' colours from the page's style. */
function coloursOf(element: Element): OctahedronColours {
	const colour = (name: string) => plainColour(getComputedStyle(element).getPropertyValue(name));
	return { line: colour("--ink"), handle: colour("--wine"), rim: colour("--paper") };
}

/** Resolves a CSS colour, which may use `light-dark()`, to a plain one with the help of an invisible element. */
function plainColour(colour: string): string {
	const probe = document.createElement("i");
	probe.style.color = colour;
	document.body.append(probe);
	const plain = getComputedStyle(probe).color;
	probe.remove();
	return plain;
}
