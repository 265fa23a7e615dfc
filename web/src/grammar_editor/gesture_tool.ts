import { html, svg } from "lit";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { EditorContext } from "../ui/editor_context";
import { LazyInteraction } from "../ui/handles/lazy_interaction";
import type { Tool } from "../ui/tool";
import type { Pair } from "./gestures/pair";
import { text } from "./messages.generated";
import type { GrammarContext, GrammarSource } from "./source";

/** Device that controls the two numbers. */
export type DrivenBy = "pointer" | "gamepad" | "camera";

export interface GestureState extends Pair {
	readonly open: boolean;
	readonly by: DrivenBy;
	/** Message about the device. */
	readonly message: string;
}

export type GestureTool = Tool<Specimen, Plant, GestureState>;

/** Context shared by all parts of the gesture tool. */
export interface Gestures {
	readonly context: GrammarContext;
	readonly tool: GestureTool;
	readonly source?: GrammarSource;
}

const HAND = svg`<path d="M7 10.5V5.2a1.2 1.2 0 0 1 2.4 0V9m0-4.6a1.2 1.2 0 0 1 2.4 0V9m0-3.2a1.2 1.2 0 0 1 2.4 0v5.4c0 3.4-1.8 5.3-4.6 5.3-2.4 0-3.4-1-4.8-3.4l-1.6-2.8c-.7-1.3.9-2.2 1.8-1.1L7 11.3"/>`;
const AT_FIRST: GestureState = { open: false, by: "pointer", across: undefined, up: undefined, message: "" };

/**
 * Creates the tool that controls two numbers of the document at once, by the two directions of a pointer, a stick or
 * the user's hand before the camera (Petrenko 2014, section 4.3.3).
 * @param source source of the text whose constants can be controlled; absent if the model has no text
 */
export function gestureTool<S extends Specimen, G extends Plant>(source?: GrammarSource<S>): Tool<S, G> {
	const tool: GestureTool = {
		name: "gestures",
		initial: AT_FIRST,
		press: (context) => {
			const state = context.toolState(tool);
			context.setToolState(tool, { ...state, open: !state.open, message: "" });
		},
		button: {
			slot: "gestures",
			icon: HAND,
			get label() {
				return text("gestures");
			},
			pressed: (context) => context.toolState(tool).open,
		},
		key: {
			letter: "j",
			get description() {
				return text("gestures_key");
			},
		},
		keys: [
			{
				keys: ["← → ↑ ↓"],
				get description() {
					return text("gestures_arrows");
				},
			},
		],
		bar: {
			get title() {
				return text("gestures");
			},
			draw: (context) => html`<panicle-gestures .context=${context} .gestures=${gestures(context)}></panicle-gestures>`,
		},
		/** Creates the interaction, whose script is loaded when the tool is first opened. */
		interaction: (view, context) =>
			new LazyInteraction({
				context,
				wanted: () => context.toolState(tool).open,
				fetch: async () => {
					const { GestureInteraction } = await import("./gestures/gestures");
					return new GestureInteraction(view, gestures(context));
				},
				onFetchFailed: () => context.setToolState(tool, { ...context.toolState(tool), open: false }),
			}),
	};
	const gestures = (context: EditorContext): Gestures => ({
		context: context as GrammarContext,
		tool,
		...(source ? { source: source as unknown as GrammarSource } : {}),
	});
	return tool as unknown as Tool<S, G>;
}
