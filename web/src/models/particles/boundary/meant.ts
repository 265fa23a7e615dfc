import type { Stateful } from "../../../ui/editor_context";

/** The grip of a flat view that was last touched: the one that buttons mean. */
export const MEANT: Stateful<string> = { name: "meant", initial: "" };
