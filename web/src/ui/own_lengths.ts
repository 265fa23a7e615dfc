import type { Stateful } from "./editor_context";

/** Whether lengths that a model counts in a unit of its own say that too, beside the millimetres. */
export const OWN_LENGTHS: Stateful<boolean> & Required<Pick<Stateful<boolean>, "recall">> = {
	name: "own_lengths",
	initial: false,
	recall: (stored) => stored === true,
};
