/**
 * Selects the groups and parameters that the panel shows: the basics, then those active for the specimen, and the
 * tools' additions.
 */

import type { Specimen } from "../specimen/specimen";
import type { Group, ParameterEntry, Table } from "../specimen/table";
import { BASICS, type Tool } from "../ui/tool";
import { text } from "./messages.generated";

export interface PanelGroup {
	readonly group: Group;
	readonly entries: readonly ParameterEntry[];
	/** Tools with something above the group's controls, and below them. */
	readonly above: readonly Tool[];
	readonly below: readonly Tool[];
}

/** Key of the disclosure that contains every group but the basics and the numbers. */
export const ADVANCED = "advanced";

/**
 * Returns the groups that are not empty: the basics, tools' own groups, then the table's in its order without the
 * basics, then the tools' groups marked `last`.
 * @param tools the tools that apply to the specimen
 */
export function groupsFor(table: Table, specimen: Specimen, tools: readonly Tool[]): readonly PanelGroup[] {
	const elsewhere = new Set(tools.flatMap(({ parameters = [] }) => parameters));
	const isShown = (entry: ParameterEntry) => table.isActive(specimen, entry) && !elsewhere.has(entry.key);
	const others = table.entries.filter((entry) => entry.basic === undefined && isShown(entry));
	const brought = tools.flatMap(({ panel }) => (typeof panel?.group === "object" ? [panel.group] : []));
	const [last, first] = [true, false].map((end) =>
		[...new Set(brought)].filter((group) => (group.last ?? false) === end),
	);
	const quantities = tools.flatMap((tool) => tool.quantities?.(specimen) ?? []);
	const basics: Group = { key: BASICS, title: text("panel_basics"), help: "", plain: true };
	return [basics, ...first, ...table.groups, ...last]
		.map((group) => {
			const own = tools.filter(({ panel }) => panel?.group === group.key || panel?.group === group);
			return {
				group,
				entries:
					group === basics
						? [...quantities, ...table.basics.filter(isShown)]
						: others.filter((entry) => entry.group === group.key),
				above: own.filter(({ panel }) => panel?.place === "above"),
				below: own.filter(({ panel }) => panel?.place === "below"),
			};
		})
		.filter(({ entries, above, below }) => entries.length + above.length + below.length > 0);
}

/** Returns the parameters that a tool's bar animates: the panel shows no control for them. */
export function runningBy(tools: readonly Tool[] = []): readonly string[] {
	return tools.flatMap(({ bar, parameters = [] }) => (bar ? parameters : []));
}

/** Returns the tools that apply to a specimen. */
export function applying(tools: readonly Tool[] = [], specimen: Specimen): readonly Tool[] {
	return tools.filter(({ applies }) => applies?.(specimen) ?? true);
}
