/** A tool to walk through a stand by keys, drags and buttons. */

import { html, nothing, svg } from "lit";
import type { EditorContext } from "../../../ui/editor_context";
import { EditorElement } from "../../../ui/editor_element";
import { takeFocus } from "../../../ui/take_focus";
import type { Tool, ToolInteraction, ToolView } from "../../../ui/tool";
import { betweenRows } from "../alley";
import { text } from "../messages.generated";
import type { StandSpecimen } from "../specimen";
import type { StandPlant } from "../stand_plant";
import { atFront, gazeOf, type StandPose, type StandStep, stepped, turned } from "../walker";

const WALK = svg`<path d="M10.5 3.2a1.3 1.3 0 1 1 0 2.6 1.3 1.3 0 0 1 0-2.6M9.8 7.4 7.4 9.6 7 12M9.8 7.4l1.6 3.4L9.6 14l-2 3.4M11.4 10.8l1.8 2.6.6 3.6M11 8.6l2.6 1.6"/>`;

/** The walker's pose; undefined while not walking. */
type Walking = StandPose | undefined;
type StandContext = EditorContext<StandSpecimen, StandPlant>;

const KEYS: Readonly<Record<string, StandStep>> = {
	KeyW: "forward",
	ArrowUp: "forward",
	KeyS: "back",
	ArrowDown: "back",
	KeyA: "left",
	KeyD: "right",
	ArrowLeft: "turn left",
	ArrowRight: "turn right",
	PageUp: "look up",
	PageDown: "look down",
};
const BUTTONS = [
	["turn left", "turn_left", "↶"],
	["left", "step_left", "←"],
	["forward", "walk_forward", "↑"],
	["back", "walk_back", "↓"],
	["right", "step_right", "→"],
	["turn right", "turn_right", "↷"],
] as const;
/** Rotation by a drag across the whole canvas, degrees. */
const SWEEP = 90;

/** The tool that shows the stand from eye level, as a walker sees it. */
export const walk: Tool<StandSpecimen, StandPlant, Walking> = {
	name: "walk",
	initial: undefined,
	press: (context) => {
		const { grown } = context.state;
		context.setToolState(walk, context.toolState(walk) || !grown ? undefined : (betweenRows(grown) ?? atFront(grown)));
	},
	button: {
		slot: "view",
		icon: WALK,
		get label() {
			return text("walk");
		},
		pressed: (context) => context.toolState(walk) !== undefined,
	},
	key: {
		letter: "w",
		get description() {
			return text("walk_key");
		},
	},
	holdsLetters: (context) => context.toolState(walk) !== undefined,
	keys: [
		{
			keys: ["W A S D", "↑ ↓"],
			get description() {
				return text("walk_key_move");
			},
		},
		{
			keys: ["← →", "Page Up", "Page Down"],
			get description() {
				return text("walk_key_look");
			},
		},
		{
			keys: ["Esc"],
			get description() {
				return text("walk_key_leave");
			},
		},
	],
	bar: {
		get title() {
			return text("walk_title");
		},
		draw: (context) => html`<panicle-walk-bar .context=${context}></panicle-walk-bar>`,
	},
	interaction: (view, context) => new WalkInteraction(view, context),
};

/** Moves the walker by one step, if the user is walking. */
function takeStep(context: StandContext, step: StandStep): void {
	const { grown } = context.state;
	const pose = context.toolState(walk);
	if (grown && pose) context.setToolState(walk, stepped(pose, step, grown));
}

/** Buttons for the steps, visible while walking. */
class WalkBar extends EditorElement<StandContext> {
	/** Returns the values whose change redraws the bar. */
	protected override shows(context: StandContext): readonly unknown[] {
		return [context.toolState(walk) !== undefined];
	}

	/** Renders buttons to walk and turn, for touch screens, and one that leaves the walk. */
	protected override draw(context: StandContext): unknown {
		if (context.toolState(walk) === undefined) return nothing;
		return html`<p class="walk-keys">${text("walk_help")}</p>
		<div class="walk-bar">
			${BUTTONS.map(
				([step, label, sign]) =>
					html`<button class="button icon" type="button" aria-label=${text(label)} title=${text(label)} @click=${() => takeStep(context, step)}
					><span aria-hidden="true">${sign}</span></button>`,
			)}
			<button class="button" type="button" @click=${() => context.setToolState(walk, undefined)}>${text("leave")}</button>
		</div>`;
	}
}

customElements.define("panicle-walk-bar", WalkBar);

class WalkInteraction implements ToolInteraction<StandSpecimen, StandPlant> {
	readonly #view: ToolView;
	readonly #context: StandContext;
	readonly #disposed = new AbortController();
	#shown: Walking;
	#ground: StandPlant["meshes"] | undefined;
	#drag: { readonly pointer: number; x: number; y: number } | undefined;

	/** Listens in the capturing phase, before the camera controls and the page's shortcuts. */
	constructor(view: ToolView, context: StandContext) {
		this.#view = view;
		this.#context = context;
		const { canvas } = view;
		const options = { signal: this.#disposed.signal, capture: true };
		window.addEventListener("keydown", (event) => this.#key(event), options);
		canvas.addEventListener("pointerdown", (event) => this.#startDrag(event), options);
		canvas.addEventListener("pointermove", (event) => this.#turnByDrag(event), options);
		for (const end of ["pointerup", "pointercancel"] as const)
			canvas.addEventListener(
				end,
				() => {
					this.#drag = undefined;
				},
				options,
			);
	}

	/**
	 * Applies the walker's pose to the view: switches between walking and orbiting, and looks again when the ground
	 * changes.
	 */
	update(): void {
		const pose = this.#context.toolState(walk);
		const { grown } = this.#context.state;
		if (pose === this.#shown && grown?.meshes === this.#ground) return;
		if ((pose === undefined) !== (this.#shown === undefined)) this.#view.orbiting = pose === undefined;
		const before = this.#shown;
		this.#shown = pose;
		if (!pose) this.#drag = undefined;
		this.#ground = grown?.meshes;
		if (pose && grown) {
			this.#view.look(gazeOf(pose, grown));
			if (!before) this.#view.canvas.focus({ preventScroll: true });
		} else if (before) {
			takeFocus(this.#view.canvas, ".walk-bar");
			this.#view.look(undefined);
		}
	}

	/** Removes the listeners, and gives the camera back to orbiting where the user was walking. */
	dispose(): void {
		this.#disposed.abort();
		if (!this.#shown) return;
		this.#view.orbiting = true;
		this.#view.look(undefined);
	}

	/** Moves the walker by a key; Escape ends the walk. */
	#key(event: KeyboardEvent): void {
		if (!this.#shown || event.ctrlKey || event.metaKey || event.altKey || !this.#handlesKeys(event)) return;
		const step = KEYS[event.code];
		if (event.key === "Escape") this.#context.setToolState(walk, undefined);
		else if (step) takeStep(this.#context, step);
		else return;
		event.preventDefault();
		event.stopPropagation();
	}

	/**
	 * Returns whether a key is for the walker: on the picture, on the buttons, or without focus; sliders use their arrow
	 * keys themselves.
	 */
	#handlesKeys({ target }: KeyboardEvent): boolean {
		if (document.querySelector("dialog[open]")) return false;
		return (
			target === this.#view.canvas || target === document.body || (target as Element).closest(".walk-bar") !== null
		);
	}

	/** Starts a drag that turns the view. */
	#startDrag({ pointerId: pointer, clientX: x, clientY: y }: PointerEvent): void {
		if (!this.#shown || this.#drag) return;
		this.#drag = { pointer, x, y };
		// Receives the end of the drag outside the canvas too.
		this.#view.canvas.setPointerCapture(pointer);
	}

	/** Turns the view during a drag: by SWEEP degrees for the width of the canvas. */
	#turnByDrag({ pointerId, clientX, clientY, buttons }: PointerEvent): void {
		// The drag ended without an event.
		if (buttons === 0) this.#drag = undefined;
		const drag = this.#drag;
		if (!drag || !this.#shown || pointerId !== drag.pointer) return;
		const degrees = SWEEP / Math.max(1, this.#view.canvas.clientWidth);
		const pose = turned(this.#shown, degrees * (drag.x - clientX), degrees * (clientY - drag.y));
		this.#drag = { pointer: pointerId, x: clientX, y: clientY };
		this.#context.setToolState(walk, pose);
	}
}
