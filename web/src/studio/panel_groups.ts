/** Which of the table's groups and parameters the panel shows: those that the chosen procedure heeds. */
import { PROCEDURES, type Procedure } from "../models/bunch/grown";
import { GROUPS, type GroupInfo, PARAMETERS, type ParameterInfo } from "../models/bunch/parameters.generated";
import type { Specimen } from "../specimen/specimen";

/** Those with a control of their own elsewhere: the age stands below the view, at hand on every screen. */
const ELSEWHERE: readonly string[] = ["age"];

export interface PanelGroup {
	readonly group: GroupInfo;
	readonly infos: readonly ParameterInfo[];
}

export function procedureOf({ parameters }: Pick<Specimen, "parameters">): Procedure {
	return PROCEDURES[parameters.procedure];
}

/** The groups with anything in them, in the table's order. */
export function groupsFor(procedure: Procedure): readonly PanelGroup[] {
	return BY_PROCEDURE[procedure];
}

function gather(procedure: Procedure): readonly PanelGroup[] {
	const heeded = PARAMETERS.filter(
		(info) => (info.procedure ?? procedure) === procedure && !ELSEWHERE.includes(info.key),
	);
	return GROUPS.map((group) => ({ group, infos: heeded.filter((info) => info.group === group.key) })).filter(
		({ infos }) => infos.length > 0,
	);
}

const BY_PROCEDURE: Record<Procedure, readonly PanelGroup[]> = { paper: gather("paper"), natural: gather("natural") };
