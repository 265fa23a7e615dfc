import type { EditorContext } from "../../ui/editor_context";
import { sameDocument } from "../../ui/same_document";
import { FILE_TOPIC } from "../../ui/tool";
import type { PixelImage } from "./picture";

/** What becomes of an outline that was found in a picture. */
export interface Tracing<T> {
	/** Fetches what finds it; that throws TraceError where there is none. */
	readonly tracer: () => Promise<(picture: PixelImage) => T>;
	/** Writes it into the document, as one step; returns what to say of it, undefined where there is no place for it any more. */
	readonly take: (traced: T) => { readonly title: string; readonly details: readonly string[] } | undefined;
}

/** Takes the outline of what is in a picture for the document that is open; what is wrong with the picture is notice. */
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
		context.notify("The picture was not traced", ["Part of the page could not be fetched."], {
			topic: FILE_TOPIC,
			again,
		});
		return;
	}
	try {
		const traced = trace(await reader.readPicture(file));
		const notice = isStill() ? tracing.take(traced) : undefined;
		if (notice) context.notify(notice.title, notice.details, { topic: FILE_TOPIC, brief: true });
		else context.notify("The outline was not taken", ["Another plant has come meanwhile."], { topic: FILE_TOPIC });
	} catch (error) {
		if (!(error instanceof words.TraceError || error instanceof bitmaps.PictureError)) throw error;
		context.notify("The picture was not traced", [error.message], { topic: FILE_TOPIC });
	}
}
