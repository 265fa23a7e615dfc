import { html } from "lit";
import { chooseFile } from "../../../../controls/choose_file";
import type { Change } from "../../../../controls/desk";
import { isPicture, PICTURES } from "../../../../controls/picture_file";
import { sameDocument } from "../../../../controls/same_document";
import { FILE_TOPIC } from "../../../../controls/tool";
import type { LeafSpecimen } from "../specimen";
import type { TracedLeaf } from "../trace/trace";
import type { LeafDesk, LeafTool } from "./desk";

/** An outline from a picture: chosen in the panel, or dropped on the page. */
export const trace: LeafTool = {
	name: "trace",
	initial: undefined,
	panel: { group: "shape", place: "below", draw },
	drop: {
		words: "a picture of a leaf is traced",
		takes: isPicture,
		take: (desk, file) => void traceFile(desk, file),
	},
};

function draw(desk: LeafDesk): unknown {
	const altered = desk.state.specimen.outline !== desk.preset.outline;
	const take = (file: File) => void traceFile(desk, file);
	return html`<div class="actions">
		${chooseFile({ accept: PICTURES, label: "Picture of a leaf", words: "Trace a picture…", take })}
		<button
			class="button" type="button" ?disabled=${!altered}
			@click=${() => desk.set({ details: { outline: desk.preset.outline } })}
		>Preset’s outline</button>
	</div>`;
}

/** Takes the outline of the leaf in a picture, as one step; what is wrong with the picture is said. */
export async function traceFile(desk: LeafDesk, file: Blob): Promise<void> {
	const isStill = sameDocument(desk);
	const again = () => void traceFile(desk, file);
	const [reader, tracer, words, bitmaps] = await Promise.all([
		import("../../../../controls/tracing/read_picture"),
		import("../trace/trace"),
		import("../../../../controls/tracing/picture"),
		import("../../../../controls/read_bitmap"),
	]).catch(() => []);
	if (!reader || !tracer || !words || !bitmaps) {
		desk.notify("The picture was not traced", ["Part of the page could not be fetched."], { topic: FILE_TOPIC, again });
		return;
	}
	try {
		const traced = tracer.traceLeaf(await reader.readPicture(file));
		if (!isStill()) {
			desk.notify("The outline was not taken", ["Another plant has come meanwhile."], { topic: FILE_TOPIC });
			return;
		}
		const { change, said } = asChange(traced, desk.state.specimen);
		desk.set(change);
		desk.notify(`An outline of ${traced.outline.length} points was traced`, said, { topic: FILE_TOPIC, brief: true });
	} catch (error) {
		if (!(error instanceof words.TraceError || error instanceof bitmaps.PictureError)) throw error;
		desk.notify("The picture was not traced", [error.message], { topic: FILE_TOPIC });
	}
}

/** What a traced leaf changes, and what to say of it: teeth would be cut into an outline that has its own. */
export function asChange(
	{ outline, petiole }: TracedLeaf,
	{ parameters }: LeafSpecimen,
): { change: Change; said: string[] } {
	const changed: Record<string, number> = { teeth: 0 };
	const said = parameters.teeth > 0 ? ["It has the teeth of the picture: Teeth is 0 now."] : [];
	if (petiole) {
		changed.petiole = Math.round(100 * petiole.length);
		changed.petiole_width = Math.round(10 * petiole.width * parameters.length) / 10;
		said.push("The stalk in the picture is the petiole.");
	}
	return { change: { parameters: changed, details: { outline } }, said };
}
