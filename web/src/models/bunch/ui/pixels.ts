import { html } from "lit";
import { OWN_LENGTHS } from "../../../ui/own_lengths";
import { text } from "../messages.generated";
import type { BunchTool } from "./context";

/** Switch that shows the paper's pixels beside the millimetres. */
export const pixels: BunchTool<boolean> = {
	...OWN_LENGTHS,
	panel: {
		group: "shape",
		place: "below",
		draw: (context) => html`<label class="toggle">
			<input
				type="checkbox" role="switch" .checked=${context.toolState(pixels)}
				@change=${(event: Event) => context.setToolState(pixels, (event.target as HTMLInputElement).checked)}
			>${text("pixels")}
		</label>`,
	},
};
