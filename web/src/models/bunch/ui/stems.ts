import type { BunchTool } from "./context";
import { STEMS } from "./icons";

/** Leaves the berries away in the 3-D view, and marks withered pedicels. */
export const stems: BunchTool<boolean> = {
	name: "stems",
	initial: false,
	press: (desk) => desk.setToolState(stems, !desk.toolState(stems)),
	button: { icon: STEMS, label: "Show stems only", pressed: (desk) => desk.toolState(stems) },
	key: { letter: "s", does: "Stems only, and back" },
	hands: (view, desk) => ({
		update: () => view.setMode(desk.toolState(stems) ? "stems" : undefined),
		dispose: () => view.setMode(undefined),
	}),
};
