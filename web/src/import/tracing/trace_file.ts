import type { EditorContext } from "../../ui/editor_context";
import { sameDocument } from "../../ui/same_document";
import { FILE_TOPIC } from "../../ui/tool";
import { text } from "../messages.generated";
import type { PixelImage } from "./picture";

/** Use of an outline traced from a picture. */
export interface Tracing<T> {
	/** Loads the tracer, which throws TraceError if it finds no outline. */
	readonly tracer: () => Promise<(picture: PixelImage) => T>;
	/**
	 * Writes the outline into the document as one step.
	 * @returns the notice to show; undefined if there is no longer a place for the outline
	 */
	readonly take: (traced: T) => { readonly title: string; readonly details: readonly string[] } | undefined;
}

/** Traces the outline in a picture for the open document. Shows a notice if the picture cannot be traced. */
export async function traceFile<T>(context: EditorContext, file: Blob, tracing: Tracing<T>): Promise<void> {
	const isStill = sameDocument(context);
	const again = () => void traceFile(context, file, tracing);
	const [reader, trace, words, bitmaps] = await Promise.all([
		import("./read_picture"),
		tracing.tracer(),
		import("./picture"),
		import("../../ui/read_bitmap"),
	]).catch(() => []);
	if (!reader || !trace || !words || !bitmaps) {
		context.notify(text("not_traced"), [text("part_not_loaded")], {
			topic: FILE_TOPIC,
			again,
		});
		return;
	}
	try {
		const traced = trace(await reader.readPicture(file));
		const notice = isStill() ? tracing.take(traced) : undefined;
		if (notice) context.notify(notice.title, notice.details, { topic: FILE_TOPIC, brief: true });
		else context.notify(text("not_used"), [text("plant_changed")], { topic: FILE_TOPIC });
	} catch (error) {
		if (!(error instanceof words.TraceError || error instanceof bitmaps.PictureError)) throw error;
		context.notify(text("not_traced"), [error.message], { topic: FILE_TOPIC });
	}
}
