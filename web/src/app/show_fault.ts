import type { Fault } from "../ui/editor_context";
import { GROWTH_TOPIC } from "../ui/tool";
import type { Studio } from "./studio";

/** Has what is wrong with a text said where the text is; tells whether there is such a place. */
export function showFaultInPane(studio: Studio, fault: Fault): boolean {
	const pane = studio.state.modelUi?.tools.find((tool) => tool.pane)?.pane;
	if (!pane || fault.line === 0) return false;
	if (pane.open(studio)) studio.retract(GROWTH_TOPIC);
	else pane.report(studio, fault);
	return true;
}
