import { html } from "lit";
import type { Change } from "../../../ui/editor_context";
import type { BunchSpecimen } from "../specimen";
import { type BunchContext, type BunchTool, isPaper } from "./context";

type Bent = Pick<BunchSpecimen["parameters"], "fit" | "vary">;

/** The switch between the paper's letter and what is bent of it; what it was bent by before is kept for the way back. */
export const asPrinted: BunchTool<Bent | undefined> = {
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
			>As printed
		</label>`,
	},
};

/** Whether nothing of the paper's letter is bent. */
export function isAsPrinted({ parameters }: Pick<BunchSpecimen, "parameters">): boolean {
	return parameters.fit === 0 && parameters.vary === 0;
}

/** `fit` and `vary` to 0, or back to the values they had before (else the preset's). */
export function setAsPrinted(context: BunchContext, on: boolean): void {
	const { specimen } = context.state;
	const { fit, vary } = specimen.parameters;
	const before = context.toolState(asPrinted);
	context.setToolState(asPrinted, on && !isAsPrinted(specimen) ? { fit, vary } : undefined);
	context.set(on ? LETTER : { parameters: bentOf(before ?? context.preset.parameters) });
}

const LETTER: Change = { parameters: { fit: 0, vary: 0 } };

const bentOf = ({ fit, vary }: Bent): Change["parameters"] => ({ fit, vary });
