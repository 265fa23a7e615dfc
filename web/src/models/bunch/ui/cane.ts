import type { BunchSpecimen } from "../specimen";
import { type BunchTool, isNatural } from "./context";
import { LEAF } from "./icons";

/** As many leaves as hang beside a bunch without hiding it. */
const LEAVES = 2;

/** The piece of cane that the bunch hangs from, with its leaves. */
export const cane: BunchTool<undefined> = {
	name: "cane",
	initial: undefined,
	applies: isNatural,
	press: (context) => {
		const off = onCane(context.state.specimen);
		context.set({ parameters: off ? { cane: 0, leaves: 0 } : { cane: 1, leaves: LEAVES } });
	},
	button: { icon: LEAF, label: "On the vine", pressed: (context) => onCane(context.state.specimen) },
	key: { letter: "v", does: "Cane and leaves, and back" },
};

/** Leaves bring the cane along. */
export function onCane({ parameters }: Pick<BunchSpecimen, "parameters">): boolean {
	return parameters.cane === 1 || parameters.leaves > 0;
}
