import { html } from "lit";
import { traceFile } from "../../../import/tracing/trace_file";
import { chooseFile } from "../../../ui/choose_file";
import type { Change } from "../../../ui/editor_context";
import { isPicture, PICTURES } from "../../../ui/picture_file";
import { text } from "../messages.generated";
import type { LeafSpecimen } from "../specimen";
import { LEAF_TABLE } from "../table";
import type { TracedLeaf } from "../trace/trace";
import type { LeafContext, LeafTool } from "./context";

/** A tool that traces the outline from a picture, which is chosen in the panel or dropped on the page. */
export const trace: LeafTool = {
	name: "trace",
	initial: undefined,
	panel: { group: "shape", place: "below", draw },
	drop: {
		get description() {
			return text("trace_drop");
		},
		takes: isPicture,
		take: (context, file) => void traceLeafFile(context, file),
	},
};

/** Renders the choice of a picture to trace, and a button that restores the preset's outline. */
function draw(context: LeafContext): unknown {
	const altered = context.state.specimen.outline !== context.preset.outline;
	const take = (file: File) => void traceLeafFile(context, file);
	return html`<div class="actions">
		${chooseFile({ accept: PICTURES, label: text("picture"), caption: text("trace"), take })}
		<button
			class="button" type="button" ?disabled=${!altered}
			@click=${() => context.set({ details: { outline: context.preset.outline } })}
		>${text("preset_outline")}</button>
	</div>`;
}

/** Sets the outline from a picture of a leaf, as one undo step; reports problems with the picture in a note. */
export function traceLeafFile(context: LeafContext, file: Blob): Promise<void> {
	return traceFile(context, file, {
		tracer: async () => (await import("../trace/trace")).traceLeaf,
		take: (traced) => {
			const { change, messages } = asChange(traced, context.state.specimen);
			context.set(change);
			return { title: text("traced", { count: traced.outline.length }), details: messages };
		},
	});
}

/** Returns the change that a traced leaf causes, with messages. Teeth are set to 0: the traced outline has its own. */
export function asChange(
	{ outline, petiole }: TracedLeaf,
	{ parameters }: LeafSpecimen,
): { change: Change; messages: string[] } {
	const changed: Record<string, number> = { teeth: 0 };
	const messages =
		parameters.teeth > 0 ? [text("teeth_off", { parameter: LEAF_TABLE.entry("teeth")?.label ?? "" })] : [];
	if (petiole) {
		changed.petiole = Math.round(100 * petiole.length);
		changed.petiole_width = Math.round(10 * petiole.width * parameters.length) / 10;
		messages.push(text("stalk_is_petiole"));
	}
	return { change: { parameters: changed, details: { outline } }, messages };
}
