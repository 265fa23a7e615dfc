import type { EditorContext } from "./editor_context";

/** Whether the document that is open now still is when asked: what was begun for it must change no other. */
export function sameDocument(context: Pick<EditorContext, "state">): () => boolean {
	const { model, specimen } = context.state;
	return () => context.state.model === model && context.state.specimen.preset === specimen.preset;
}
