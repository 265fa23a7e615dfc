/** Traces an organ's outline from a picture that was chosen in the panel or dropped on the page. */

import { traceFile } from "../../../../import/tracing/trace_file";
import { described } from "../../design/description";
import { describedIn } from "../../design/design";
import type { Organ } from "../../design/organs";
import { DRAWN } from "../../design/shapes";
import { text } from "../../messages.generated";
import { type Drafts, designIn, type FlowerContext } from "./drafts";

/** Sets an organ's outline to the one in a picture, as one undo step; reports errors to the user. */
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
			return { title: text("traced", { organ }), details: [text("points_movable")] };
		},
	});
}
