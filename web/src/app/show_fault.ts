import type { Fault } from "../ui/editor_context";
import { GROWTH_TOPIC } from "../ui/tool";
import type { Studio } from "./studio";

/**
 * Shows a fault of the grammar in the pane that edits the text. @returns false where there is no such pane, or the
 * fault has no line
 */
export function showFaultInPane(studio: Studio, fault: Fault): boolean {
	const pane = studio.state.modelUi?.tools.find((tool) => tool.pane)?.pane;
	if (!pane || fault.line === 0) return false;
	if (pane.open(studio)) studio.retract(GROWTH_TOPIC);
	else pane.report(studio, fault);
	return true;
}
