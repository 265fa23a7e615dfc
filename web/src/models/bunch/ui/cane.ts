import { text } from "../messages.generated";
import type { BunchSpecimen } from "../specimen";
import { type BunchTool, isNatural } from "./context";
import { LEAF } from "./icons";

/** Number of leaves that hang beside a bunch without hiding it. */
const LEAVES = 2;

/** Button for the cane that the bunch hangs from, and its leaves. */
export const cane: BunchTool<undefined> = {
	name: "cane",
	initial: undefined,
	applies: isNatural,
	press: (context) => {
		const off = onCane(context.state.specimen);
		context.set({ parameters: off ? { cane: 0, leaves: 0 } : { cane: 1, leaves: LEAVES } });
	},
	button: {
		slot: "edit",
		icon: LEAF,
		get label() {
			return text("cane");
		},
		pressed: (context) => onCane(context.state.specimen),
	},
	key: {
		letter: "v",
		get description() {
			return text("cane_key");
		},
	},
};

/** Returns whether the cane is shown; leaves include it. */
export function onCane({ parameters }: Pick<BunchSpecimen, "parameters">): boolean {
	return parameters.cane === 1 || parameters.leaves > 0;
}
