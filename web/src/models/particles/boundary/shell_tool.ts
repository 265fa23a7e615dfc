/** A switch that shows the boundary in the 3-D view. */

import { svg } from "lit";
import { createShellTool } from "../../../ui/shell_tool";
import type { Tool } from "../../../ui/tool";
import { text } from "../messages.generated";
import type { BoundedSpecimen } from "./bounded";
import type { BoundaryLayout } from "./editor/boundary_layout";
import { shellsOf } from "./editor/shell";
import type { WoodenPlant } from "./wooden_plant";

const ICON = svg`<path d="M10 3c4 0 6.5 2.8 6.5 6s-2.5 6-6.5 6-6.5-2.8-6.5-6 2.5-6 6.5-6zM3.5 9c0 1.300 2.900 2.300 6.5 2.300s6.5-1 6.5-2.300M10 15v2.5"/>`;

/** Creates the tool; its renderer is loaded when it is first switched on. */
export const boundaryShellTool = <S extends BoundedSpecimen>(
	layout: BoundaryLayout<S>,
): Tool<S, WoodenPlant, boolean> =>
	createShellTool<S, WoodenPlant>({
		name: "shell",
		icon: ICON,
		get label() {
			return text("shell");
		},
		get fetchFailedMessage() {
			return text("shell_failed");
		},
		renderer: async () => new (await import("../../../render/shell_renderer")).ShellRenderer(),
		shells: (specimen) => shellsOf(layout, specimen),
	});
