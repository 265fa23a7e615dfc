import type { Stateful } from "../../../ui/editor_context";

/** The id of the grip that was last touched in a flat view; the buttons act on it. */
export const ACTIVE_GRIP: Stateful<string> = { name: "meant", initial: "" };
