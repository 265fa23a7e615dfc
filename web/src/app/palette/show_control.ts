/** Moves the focus to controls of the page: opens the groups around one, scrolls to it and focuses it. */
import type { LitElement } from "lit";
import { BASICS } from "../../ui/tool";
import { ADVANCED } from "../panel_groups";
import type { Studio } from "../studio";

const FOCUSABLE = "input:not([type=hidden]):not([tabindex='-1']), select, textarea, button, summary";

/** Shows the control of a parameter in the panel. @returns whether the panel has it */
export async function showControl(studio: Studio, group: string, parameter: string): Promise<boolean> {
	await openGroup(studio, group);
	return focusIn(`panicle-panel [data-key="${CSS.escape(parameter)}"]`);
}

/** Opens a group of the panel, with the focus on its heading. @returns whether the panel has it */
export async function showGroup(studio: Studio, group: string): Promise<boolean> {
	await openGroup(studio, group);
	return focusIn(`panicle-panel [data-group="${CSS.escape(group)}"] > summary`);
}

/** Shows the bar of a tool below the view, by its title. @returns whether there is one */
export async function showBar(title: string): Promise<boolean> {
	return focusIn(`panicle-bars [aria-label="${CSS.escape(title)}"]`, "input[type=range]");
}

/** Opens a group of the panel, and "Advanced" if the group is in it; waits until the panel is drawn. */
async function openGroup(studio: Studio, group: string): Promise<void> {
	if (group !== BASICS) studio.setGroup(ADVANCED, true);
	studio.setGroup(group, true);
	await document.querySelector<LitElement>("panicle-panel")?.updateComplete;
}

/** Focuses the first control of an element that matches the selector, or the element itself. */
function focusIn(selector: string, control = FOCUSABLE): boolean {
	const place = document.querySelector<HTMLElement>(selector);
	if (!place) return false;
	for (let around = place.closest("details"); around; around = around.parentElement?.closest("details") ?? null) {
		around.open = true;
	}
	const checked = place.querySelector<HTMLElement>("input:checked");
	const target = checked ?? place.querySelector<HTMLElement>(control) ?? place;
	target.scrollIntoView({ block: "center" });
	target.focus({ preventScroll: true });
	return document.activeElement === target;
}
