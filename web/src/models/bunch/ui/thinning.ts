import { html } from "lit";
import { PickPointer } from "../../../ui/pick_pointer";
import { thin, unthinAll } from "../details/thinned";
import { text } from "../messages.generated";
import { type BunchContext, type BunchTool, isNatural } from "./context";
import { THIN } from "./icons";
import { stems } from "./stems";

export interface ThinningState {
	/** Whether a click in the 3-D view removes a berry. */
	readonly on: boolean;
	/** Id of the berry that is highlighted, by the pointer or in the panel. */
	readonly marked: number | undefined;
}

/** Tool for thinning by hand, by pointer in the 3-D view or in the panel. */
export const thinning: BunchTool<ThinningState> = {
	name: "thinning",
	initial: { on: false, marked: undefined },
	applies: isNatural,
	press: (context) => {
		const state = context.toolState(thinning);
		context.setToolState(thinning, { ...state, on: !state.on });
	},
	button: {
		slot: "edit",
		icon: THIN,
		get label() {
			return text("thinning_button");
		},
		pressed: (context) => context.toolState(thinning).on,
	},
	key: {
		letter: "t",
		get description() {
			return text("thinning_key");
		},
	},
	keys: [
		{
			keys: ["Delete"],
			get description() {
				return text("thinning_delete_key");
			},
		},
	],
	panel: {
		group: "berries",
		place: "below",
		subject: (context) => context.toolState(thinning).on || undefined,
		draw: (context) => html`<panicle-thinning .context=${context}></panicle-thinning>`,
	},
	/** Marks the berry under the pointer, and removes it when clicked. */
	interaction: (view, context) => {
		const pointer = new PickPointer(view, {
			name: "thinning",
			at: (x, y) => view.pick(x, y),
			mark: (id) => mark(context, id),
			take: (id) => takeOff(context, id),
		});
		return {
			update: ({ specimen }) => {
				const { on, marked } = context.toolState(thinning);
				pointer.enabled = on && isNatural(specimen) && !context.toolState(stems);
				view.mark(marked);
			},
			dispose: () => pointer.dispose(),
		};
	},
};

/** Highlights a berry, or none. */
export function mark(context: BunchContext, id: number | undefined): void {
	const state = context.toolState(thinning);
	if (id !== state.marked) context.setToolState(thinning, { ...state, marked: id });
}

/** Removes a berry and highlights `next`. */
export function takeOff(context: BunchContext, id: number, next?: number): void {
	context.replace(thin(context.state.specimen, id));
	mark(context, next);
}

/** Restores every removed berry. */
export function putBack(context: BunchContext): void {
	context.replace(unthinAll(context.state.specimen));
}
