import type { Stateful } from "../../../ui/editor_context";

/** The grip of a flat view that was last touched: the one that buttons mean. */
export const ACTIVE_GRIP: Stateful<string> = { name: "meant", initial: "" };
