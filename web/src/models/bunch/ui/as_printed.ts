import { html } from "lit";
import type { Change } from "../../../ui/editor_context";
import { text } from "../messages.generated";
import type { BunchSpecimen } from "../specimen";
import { type BunchContext, type BunchTool, isPaper } from "./context";

type Modifications = Pick<BunchSpecimen["parameters"], "fit" | "vary">;

/**
 * Switch between the paper's method as printed and our modifications of it; its state stores the modified values for
 * switching back.
 */
export const asPrinted: BunchTool<Modifications | undefined> = {
	name: "asPrinted",
	initial: undefined,
	applies: isPaper,
	panel: {
		group: "between",
		place: "above",
		draw: (context) => html`<label class="toggle">
			<input
				type="checkbox" role="switch" .checked=${isAsPrinted(context.state.specimen)}
				@change=${(event: Event) => setAsPrinted(context, (event.target as HTMLInputElement).checked)}
			>${text("as_printed")}
		</label>`,
	},
};

/** Returns whether a bunch follows the paper as printed. */
export function isAsPrinted({ parameters }: Pick<BunchSpecimen, "parameters">): boolean {
	return parameters.fit === 0 && parameters.vary === 0;
}

/** Sets `fit` and `vary` to 0, or back to their previous values (else the preset's). */
export function setAsPrinted(context: BunchContext, on: boolean): void {
	const { specimen } = context.state;
	const { fit, vary } = specimen.parameters;
	const before = context.toolState(asPrinted);
	context.setToolState(asPrinted, on && !isAsPrinted(specimen) ? { fit, vary } : undefined);
	context.set(on ? AS_PRINTED : { parameters: modificationsOf(before ?? context.preset.parameters) });
}

/** Change that turns the modifications off. */
const AS_PRINTED: Change = { parameters: { fit: 0, vary: 0 } };

/** Returns only the parameters of our modifications. */
const modificationsOf = ({ fit, vary }: Modifications): Change["parameters"] => ({ fit, vary });
