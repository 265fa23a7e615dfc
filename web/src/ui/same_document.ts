import type { EditorContext } from "./editor_context";

/**
 * Returns a function that checks whether the document open now is still open: an asynchronous action must not change
 * another one.
 */
export function sameDocument(context: Pick<EditorContext, "state">): () => boolean {
	const { model, specimen } = context.state;
	return () => context.state.model === model && context.state.specimen.preset === specimen.preset;
}
