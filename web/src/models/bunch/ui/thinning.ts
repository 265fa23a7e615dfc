import { html } from "lit";
import { PickPointer } from "../../../ui/pick_pointer";
import { thin, unthinAll } from "../details/thinned";
import { type BunchContext, type BunchTool, isNatural } from "./context";
import { THIN } from "./icons";
import { stems } from "./stems";

export interface ThinningState {
	/** Whether a click in the 3-D view takes a berry off. */
	readonly on: boolean;
	/** Id of the berry that is pointed at, in the view or on the panel. */
	readonly marked: number | undefined;
}

/** Thinning by hand: the pointer's way in the 3-D view, and in the panel the way without one. */
export const thinning: BunchTool<ThinningState> = {
	name: "thinning",
	initial: { on: false, marked: undefined },
	applies: isNatural,
	press: (desk) => {
		const state = desk.toolState(thinning);
		desk.setToolState(thinning, { ...state, on: !state.on });
	},
	button: { icon: THIN, label: "Thin", pressed: (desk) => desk.toolState(thinning).on },
	key: { letter: "t", does: "Thin by hand: a click takes a berry off; and back" },
	keys: [{ keys: ["Delete"], does: "On the berry's slider: take it off" }],
	panel: {
		group: "berries",
		place: "below",
		draw: (desk) => html`<panicle-thinning .desk=${desk}></panicle-thinning>`,
	},
	hands: (view, desk) => {
		const pointer = new PickPointer(view, {
			name: "thinning",
			at: (x, y) => view.pick(x, y),
			mark: (id) => mark(desk, id),
			take: (id) => takeOff(desk, id),
		});
		return {
			update: ({ specimen }) => {
				const { on, marked } = desk.toolState(thinning);
				pointer.enabled = on && isNatural(specimen) && !desk.toolState(stems);
				view.mark(marked);
			},
			dispose: () => pointer.dispose(),
		};
	},
};

/** Points at a berry, or at none. */
export function mark(desk: BunchContext, id: number | undefined): void {
	const state = desk.toolState(thinning);
	if (id !== state.marked) desk.setToolState(thinning, { ...state, marked: id });
}

/** Takes a berry off; the mark goes on to `next`. */
export function takeOff(desk: BunchContext, id: number, next?: number): void {
	desk.replace(thin(desk.state.specimen, id));
	mark(desk, next);
}

/** Gives back every berry that was taken off. */
export function putBack(desk: BunchContext): void {
	desk.replace(unthinAll(desk.state.specimen));
}
