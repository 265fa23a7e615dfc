import { html } from "lit";
import { traceFile } from "../../../import/tracing/trace_file";
import { chooseFile } from "../../../ui/choose_file";
import type { Change } from "../../../ui/editor_context";
import { isPicture, PICTURES } from "../../../ui/picture_file";
import type { LeafSpecimen } from "../specimen";
import type { TracedLeaf } from "../trace/trace";
import type { LeafContext, LeafTool } from "./context";

/** A tool that traces the outline from a picture, which is chosen in the panel or dropped on the page. */
export const trace: LeafTool = {
	name: "trace",
	initial: undefined,
	panel: { group: "shape", place: "below", draw },
	drop: {
		words: "a picture of a leaf is traced",
		takes: isPicture,
		take: (context, file) => void traceLeafFile(context, file),
	},
};

function draw(context: LeafContext): unknown {
	const altered = context.state.specimen.outline !== context.preset.outline;
	const take = (file: File) => void traceLeafFile(context, file);
	return html`<div class="actions">
		${chooseFile({ accept: PICTURES, label: "Picture of a leaf", words: "Trace a picture…", take })}
		<button
			class="button" type="button" ?disabled=${!altered}
			@click=${() => context.set({ details: { outline: context.preset.outline } })}
		>Preset’s outline</button>
	</div>`;
}

/** Sets the outline from a picture of a leaf, as one undo step; reports problems with the picture in a note. */
export function traceLeafFile(context: LeafContext, file: Blob): Promise<void> {
	return traceFile(context, file, {
		tracer: async () => (await import("../trace/trace")).traceLeaf,
		take: (traced) => {
			const { change, messages } = asChange(traced, context.state.specimen);
			context.set(change);
			return { title: `An outline of ${traced.outline.length} points was traced`, details: messages };
		},
	});
}

/** The change that a traced leaf causes, with messages. Teeth are set to 0: the traced outline has its own. */
export function asChange(
	{ outline, petiole }: TracedLeaf,
	{ parameters }: LeafSpecimen,
): { change: Change; messages: string[] } {
	const changed: Record<string, number> = { teeth: 0 };
	const messages = parameters.teeth > 0 ? ["It has the teeth of the picture: Teeth is 0 now."] : [];
	if (petiole) {
		changed.petiole = Math.round(100 * petiole.length);
		changed.petiole_width = Math.round(10 * petiole.width * parameters.length) / 10;
		messages.push("The stalk in the picture is the petiole.");
	}
	return { change: { parameters: changed, details: { outline } }, messages };
}
