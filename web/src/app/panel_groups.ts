/** Selects the groups and parameters that the panel shows: those active for the specimen, and the tools' additions. */

import type { Specimen } from "../specimen/specimen";
import type { Group, ParameterEntry, Table } from "../specimen/table";
import type { Tool } from "../ui/tool";

export interface PanelGroup {
	readonly group: Group;
	readonly entries: readonly ParameterEntry[];
	/** Tools with something above the group's controls, and below them. */
	readonly above: readonly Tool[];
	readonly below: readonly Tool[];
}

/**
 * The groups that are not empty: tools' own groups, then the table's in its order, then the tools' groups marked `last`.
 * @param tools the tools that apply to the specimen
 */
export function groupsFor(table: Table, specimen: Specimen, tools: readonly Tool[]): readonly PanelGroup[] {
	const elsewhere = new Set(tools.flatMap(({ parameters = [] }) => parameters));
	const active = table.entries.filter((entry) => table.isActive(specimen, entry) && !elsewhere.has(entry.key));
	const brought = tools.flatMap(({ panel }) => (typeof panel?.group === "object" ? [panel.group] : []));
	const [last, first] = [true, false].map((end) =>
		[...new Set(brought)].filter((group) => (group.last ?? false) === end),
	);
	return [...first, ...table.groups, ...last]
		.map((group) => {
			const own = tools.filter(({ panel }) => panel?.group === group.key || panel?.group === group);
			return {
				group,
				entries: active.filter((entry) => entry.group === group.key),
				above: own.filter(({ panel }) => panel?.place === "above"),
				below: own.filter(({ panel }) => panel?.place === "below"),
			};
		})
		.filter(({ entries, above, below }) => entries.length + above.length + below.length > 0);
}

/** Parameters that a tool's bar animates: the panel shows no control for them. */
export function runningBy(tools: readonly Tool[] = []): readonly string[] {
	return tools.flatMap(({ bar, parameters = [] }) => (bar ? parameters : []));
}

/** The tools that apply to a specimen. */
export function applying(tools: readonly Tool[] = [], specimen: Specimen): readonly Tool[] {
	return tools.filter(({ applies }) => applies?.(specimen) ?? true);
}
