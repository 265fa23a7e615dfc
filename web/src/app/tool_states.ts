/** States of models' tools: plain data by the names of model and tool. */
import type { Stateful } from "../ui/editor_context";

export type ToolStates = Readonly<Record<string, Readonly<Record<string, unknown>>>>;

/**
 * Adds the states of a model's tools: the current state, else the remembered one, else the initial one.
 * @param remembered states of former visits
 */
export function withTools(
	states: ToolStates,
	model: string,
	tools: readonly Stateful<unknown>[],
	remembered: ToolStates,
): ToolStates {
	const own = tools.map((tool) => [tool.name, tool.recall?.(remembered[model]?.[tool.name]) ?? tool.initial] as const);
	return { ...states, [model]: { ...Object.fromEntries(own), ...states[model] } };
}

/** Returns the state of a tool; its initial one where none was set. */
export function stateOf<T>(states: ToolStates, model: string, tool: Stateful<T>): T {
	const own = states[model];
	return own && tool.name in own ? (own[tool.name] as T) : tool.initial;
}

/** Returns the states with another state of a tool. */
export function withState<T>(states: ToolStates, model: string, tool: Stateful<T>, state: T): ToolStates {
	return { ...states, [model]: { ...states[model], [tool.name]: state } };
}
