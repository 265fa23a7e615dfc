import type { BunchTool } from "./context";
import { STEMS } from "./icons";

/** Tool that hides the berries in the 3-D view and marks withered pedicels. */
export const stems: BunchTool<boolean> = {
	name: "stems",
	initial: false,
	press: (context) => context.setToolState(stems, !context.toolState(stems)),
	button: { icon: STEMS, label: "Show stems only", pressed: (context) => context.toolState(stems) },
	key: { letter: "s", does: "Stems only, and back" },
	interaction: (view, context) => ({
		update: () => view.setMode(context.toolState(stems) ? "stems" : undefined),
		dispose: () => view.setMode(undefined),
	}),
};
