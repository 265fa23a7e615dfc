import { text } from "../messages.generated";
import type { BunchTool } from "./context";
import { STEMS } from "./icons";

/** Tool that hides the berries in the 3-D view and marks withered pedicels. */
export const stems: BunchTool<boolean> = {
	name: "stems",
	initial: false,
	press: (context) => context.setToolState(stems, !context.toolState(stems)),
	button: {
		slot: "view",
		icon: STEMS,
		get label() {
			return text("stems");
		},
		pressed: (context) => context.toolState(stems),
	},
	key: {
		letter: "s",
		get description() {
			return text("stems_key");
		},
	},
	interaction: (view, context) => ({
		update: () => view.setMode(context.toolState(stems) ? "stems" : undefined),
		dispose: () => view.setMode(undefined),
	}),
};
