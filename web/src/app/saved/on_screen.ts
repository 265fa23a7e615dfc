/** Between the library and the studio: what is on screen is saved, what is saved comes on screen. */
import { modelNamed } from "../../models/index";
import { decodeLink, encodeLink, linkParts } from "../../specimen/link";
import { growsAlike } from "../../specimen/same";
import { caughtUp, plantToSave } from "../files/plant_to_save";
import type { Studio } from "../studio";
import { VERSION } from "../version";
import { modelOf, type Saved } from "./saved";
import { thumbnailOf } from "./thumbnail";

const TOPIC = "saved specimen";

/**
 * The plant in view, to be added to a library. Without a 3-D view it has no picture.
 * @throws Error where nothing has grown
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
 * Opens one in place of what is on screen, as one step. Once it has grown it is compared with the plant that was saved; where it is another,
 * that is said.
 * @throws what modelNamed throws, where its model cannot be fetched
 */
export async function openSaved(studio: Studio, saved: Saved): Promise<void> {
	const { query, fragment } = linkParts(saved.link);
	const model = await modelNamed(modelOf(saved));
	const restored = await decodeLink(model, query, fragment);
	studio.take(model, restored, TOPIC);
	if (saved.fingerprint === undefined) return;
	await caughtUp(studio);
	const { shown } = studio.state;
	// Where the person has gone on meanwhile, or nothing could grow, it is of something else.
	if (!shown || !growsAlike(shown.from, restored.specimen) || shown.grown.fingerprint === saved.fingerprint) return;
	const made = saved.app === "" ? "It was saved" : `It was saved with version ${saved.app}`;
	studio.notify(
		`“${saved.name}” grows otherwise than when it was saved`,
		[`${made}, fingerprint ${saved.fingerprint}; it is ${shown.grown.fingerprint} here.`],
		{ topic: `${TOPIC} grown`, untouched: true },
	);
}
