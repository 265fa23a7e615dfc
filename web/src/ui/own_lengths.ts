import type { Stateful } from "./editor_context";

/** Whether lengths in a model's own unit show that unit next to millimetres. */
export const OWN_LENGTHS: Stateful<boolean> & Required<Pick<Stateful<boolean>, "recall">> = {
	name: "own_lengths",
	initial: false,
	recall: (stored) => stored === true,
};
