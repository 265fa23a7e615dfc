/** A tool to walk through a stand by keys, drags and buttons. */
import { html, nothing, svg } from "lit";
import type { EditorContext } from "../../../ui/editor_context";
import { EditorElement } from "../../../ui/editor_element";
import { takeFocus } from "../../../ui/take_focus";
import type { Tool, ToolInteraction, ToolView } from "../../../ui/tool";
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
const BUTTONS: readonly (readonly [step: StandStep, label: string, sign: string])[] = [
	["turn left", "Turn left", "↶"],
	["left", "Step left", "←"],
	["forward", "Walk forward", "↑"],
	["back", "Walk back", "↓"],
	["right", "Step right", "→"],
	["turn right", "Turn right", "↷"],
];
/** Rotation by a drag across the whole canvas, degrees. */
const SWEEP = 90;

export const walk: Tool<StandSpecimen, StandPlant, Walking> = {
	name: "walk",
	initial: undefined,
	press: (context) => {
		const { grown } = context.state;
		context.setToolState(walk, context.toolState(walk) || !grown ? undefined : atFront(grown));
	},
	button: { icon: WALK, label: "Walk through it", pressed: (context) => context.toolState(walk) !== undefined },
	key: { letter: "w", does: "Walk through the stand" },
	holdsLetters: (context) => context.toolState(walk) !== undefined,
	keys: [
		{ keys: ["W A S D", "↑ ↓"], does: "While walking, on the picture: forward, left, back, right" },
		{ keys: ["← →", "Page Up", "Page Down"], does: "While walking, on the picture: look around" },
		{ keys: ["Esc"], does: "While walking, on the picture: leave" },
	],
	bar: {
		title: "Walk",
		draw: (context) => html`<panicle-walk-bar .context=${context}></panicle-walk-bar>`,
	},
	interaction: (view, context) => new WalkInteraction(view, context),
};

function go(context: StandContext, step: StandStep): void {
	const { grown } = context.state;
	const pose = context.toolState(walk);
	if (grown && pose) context.setToolState(walk, stepped(pose, step, grown));
}

/** Buttons for the steps, visible while walking. */
class WalkBar extends EditorElement<StandContext> {
	protected override shows(context: StandContext): readonly unknown[] {
		return [context.toolState(walk) !== undefined];
	}

	protected override draw(context: StandContext): unknown {
		if (context.toolState(walk) === undefined) return nothing;
		return html`<p class="walk-keys">Arrow keys walk and turn, a drag looks around, Esc leaves.</p>
		<div class="walk-bar">
			${BUTTONS.map(
				([step, label, sign]) =>
					html`<button class="button icon" type="button" aria-label=${label} title=${label} @click=${() => go(context, step)}
					><span aria-hidden="true">${sign}</span></button>`,
			)}
			<button class="button" type="button" @click=${() => context.setToolState(walk, undefined)}>Leave</button>
		</div>`;
	}
}

customElements.define("panicle-walk-bar", WalkBar);

class WalkInteraction implements ToolInteraction<StandSpecimen, StandPlant> {
	readonly #view: ToolView;
	readonly #context: StandContext;
	readonly #ended = new AbortController();
	#shown: Walking;
	#ground: StandPlant["meshes"] | undefined;
	#drag: { readonly pointer: number; x: number; y: number } | undefined;

	constructor(view: ToolView, context: StandContext) {
		this.#view = view;
		this.#context = context;
		const { canvas } = view;
		const options = { signal: this.#ended.signal, capture: true };
		window.addEventListener("keydown", (event) => this.#key(event), options);
		canvas.addEventListener("pointerdown", (event) => this.#down(event), options);
		canvas.addEventListener("pointermove", (event) => this.#move(event), options);
		for (const end of ["pointerup", "pointercancel"] as const)
			canvas.addEventListener(
				end,
				() => {
					this.#drag = undefined;
				},
				options,
			);
	}

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

	dispose(): void {
		this.#ended.abort();
		if (!this.#shown) return;
		this.#view.orbiting = true;
		this.#view.look(undefined);
	}

	#key(event: KeyboardEvent): void {
		if (!this.#shown || event.ctrlKey || event.metaKey || event.altKey || !this.#handlesKeys(event)) return;
		const step = KEYS[event.code];
		if (event.key === "Escape") this.#context.setToolState(walk, undefined);
		else if (step) go(this.#context, step);
		else return;
		event.preventDefault();
		event.stopPropagation();
	}

	/**
	 * Whether a key is for the walker: on the picture, on the buttons, or without focus; sliders keep their arrow
	 * keys.
	 */
	#handlesKeys({ target }: KeyboardEvent): boolean {
		if (document.querySelector("dialog[open]")) return false;
		return (
			target === this.#view.canvas || target === document.body || (target as Element).closest(".walk-bar") !== null
		);
	}

	#down({ pointerId: pointer, clientX: x, clientY: y }: PointerEvent): void {
		if (!this.#shown || this.#drag) return;
		this.#drag = { pointer, x, y };
		// Receives the end of the drag outside the canvas too.
		this.#view.canvas.setPointerCapture(pointer);
	}

	#move({ pointerId, clientX, clientY, buttons }: PointerEvent): void {
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
