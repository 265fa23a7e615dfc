import type { EditorContext } from "./editor_context";

/** Whether the document that is on the desk now still is when asked: what was begun for it must change no other. */
export function sameDocument(desk: Pick<EditorContext, "state">): () => boolean {
	const { model, specimen } = desk.state;
	return () => desk.state.model === model && desk.state.specimen.preset === specimen.preset;
}
