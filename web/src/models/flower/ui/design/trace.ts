/** The outline of a petal, a sepal or a leaf from a picture: chosen in the panel, or dropped on the page. */
import { traceFile } from "../../../../import/tracing/trace_file";
import { described } from "../../design/description";
import { describedIn } from "../../design/design";
import type { Organ } from "../../design/organs";
import { DRAWN } from "../../design/shapes";
import { type Drafts, designIn, type FlowerContext } from "./drafts";

/** Takes the outline of what is in a picture for an organ, as one step; what is wrong with the picture is said. */
export function traceInto(context: FlowerContext, drafts: Drafts, organ: Organ, file: Blob): Promise<void> {
	return traceFile(context, file, {
		tracer: async () => {
			const { tracedMargin } = await import("../../design/traced");
			return (picture) => tracedMargin(picture, organ);
		},
		take: ({ margin, wide }) => {
			const design = designIn(context.state.specimen);
			if (!design) return undefined;
			const before = describedIn(design, organ);
			const width = Number(before.values.length) * wide;
			drafts.set(context, described(before, { outline: DRAWN, width }, margin));
			return { title: `The outline of a ${organ} was traced`, details: ["Its points can be dragged."] };
		},
	});
}
