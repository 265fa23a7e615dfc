/** The outline of a petal, a sepal or a leaf from a picture: chosen in the panel, or dropped on the page. */
import { sameDocument } from "../../../../controls/same_document";
import { FILE_TOPIC } from "../../../../controls/tool";
import { described } from "../../design/description";
import { describedIn } from "../../design/design";
import type { Organ } from "../../design/organs";
import { DRAWN } from "../../design/shapes";
import { type Drafts, designIn, type FlowerDesk } from "./drafts";

/** Takes the outline of what is in a picture for an organ, as one step; what is wrong with the picture is said. */
export async function traceInto(desk: FlowerDesk, drafts: Drafts, organ: Organ, file: Blob): Promise<void> {
	const isStill = sameDocument(desk);
	const again = () => void traceInto(desk, drafts, organ, file);
	const [reader, tracer, words, bitmaps] = await Promise.all([
		import("../../../../controls/tracing/read_picture"),
		import("../../design/traced"),
		import("../../../../controls/tracing/picture"),
		import("../../../../controls/read_bitmap"),
	]).catch(() => []);
	if (!reader || !tracer || !words || !bitmaps) {
		desk.notify("The picture was not traced", ["Part of the page could not be fetched."], { topic: FILE_TOPIC, again });
		return;
	}
	try {
		const { margin, wide } = tracer.tracedMargin(await reader.readPicture(file), organ);
		const design = designIn(desk.state.specimen);
		if (!isStill() || !design) {
			desk.notify("The outline was not taken", ["Another plant has come meanwhile."], { topic: FILE_TOPIC });
			return;
		}
		const before = describedIn(design, organ);
		const width = Number(before.values.length) * wide;
		drafts.set(desk, described(before, { outline: DRAWN, width }, margin));
		desk.notify(`The outline of a ${organ} was traced`, ["Its points can be dragged."], {
			topic: FILE_TOPIC,
			brief: true,
		});
	} catch (error) {
		if (!(error instanceof words.TraceError || error instanceof bitmaps.PictureError)) throw error;
		desk.notify("The picture was not traced", [error.message], { topic: FILE_TOPIC });
	}
}
