/** Converts between the studio's plant and saved specimens. */
import { modelNamed } from "../../models/index";
import { decodeLink, encodeLink, linkParts } from "../../specimen/link";
import { growsAlike } from "../../specimen/same";
import { caughtUp, plantToSave } from "../files/plant_to_save";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { VERSION } from "../version";
import { modelOf, type Saved } from "./saved";
import { thumbnailOf } from "./thumbnail";

const TOPIC = "saved specimen";

/**
 * Returns the plant in view as a saved specimen; without a picture if there is no 3-D view.
 * @throws Error if nothing has grown
 */
export async function savedOf(studio: Studio, name: string): Promise<Saved> {
	const { model, from, grown } = await plantToSave(studio);
	const take = studio.state.picture;
	const picture = take && (await thumbnailOf(take).catch(() => undefined));
	return {
		id: crypto.randomUUID(),
		name,
		link: await encodeLink(model, from),
		at: Date.now(),
		app: VERSION,
		fingerprint: grown.fingerprint,
		...(picture ? { picture } : {}),
	};
}

/**
 * Opens a saved specimen, as one undo step. Compares the grown plant's fingerprint with the saved one, and notifies of
 * a difference.
 * @throws errors of modelNamed, if its model cannot be fetched
 */
export async function openSaved(studio: Studio, saved: Saved): Promise<void> {
	const { query, fragment } = linkParts(saved.link);
	const model = await modelNamed(modelOf(saved));
	const restored = await decodeLink(model, query, fragment);
	studio.take(model, restored, TOPIC);
	if (saved.fingerprint === undefined) return;
	await caughtUp(studio);
	const { shown } = studio.state;
	// If the document has changed meanwhile, or could not grow, there is nothing to compare.
	if (!shown || !growsAlike(shown.from, restored.specimen) || shown.grown.fingerprint === saved.fingerprint) return;
	const fingerprints = { saved: saved.fingerprint, grown: shown.grown.fingerprint };
	const details =
		saved.app === ""
			? text("saved_differs_details", fingerprints)
			: text("saved_differs_version", { ...fingerprints, version: saved.app });
	const options = { topic: `${TOPIC} grown`, untouched: true };
	studio.notify(text("saved_differs", { name: saved.name }), [details], options);
}
