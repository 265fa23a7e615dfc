/** Opens recent plants, with the parts that their links cannot hold. */
import { modelNamed } from "../../models/index";
import type { PageModel } from "../../models/page_model";
import { decodeLink, linkParts, modelInQuery } from "../../specimen/link";
import type { Restored } from "../../specimen/restore";
import { withExtra } from "../session/stored_specimen";
import type { Studio } from "../studio";
import { fetchFailed } from "../types";
import { text } from "./messages.generated";
import type { RecentPlant } from "./recent_plant";
import { ownRecents } from "./recents";

/** Reads the plant of an address that names a recent plant (recent_address.ts). */
export async function readRecentAddress(
	model: PageModel,
	{ search, hash }: Pick<Location, "search" | "hash">,
	id: string,
): Promise<Restored> {
	const restored = await decodeLink(model, search, hash);
	const { extra } = await ownRecents().content(id);
	return extra === undefined ? restored : { specimen: withExtra(model, restored.specimen, extra), notes: [] };
}

/** Opens a recent plant as one undo step; a failure is reported as a notice that tries again. */
export async function openRecent(studio: Studio, plant: RecentPlant): Promise<void> {
	try {
		await takeRecent(studio, plant);
	} catch {
		const again = () => void openRecent(studio, plant);
		studio.notify(text("not_opened", { title: plant.title }), fetchFailed(), { again });
	}
}

/** Opens a recent plant. @throws errors of modelNamed, if its model cannot be fetched */
async function takeRecent(studio: Studio, { id, link, extra }: RecentPlant): Promise<void> {
	const { query, fragment } = linkParts(link);
	const model = await modelNamed(modelInQuery(query));
	const address = { search: query, hash: fragment };
	const restored =
		extra === "stored" ? await readRecentAddress(model, address, id) : await decodeLink(model, query, fragment);
	studio.take(model, restored, "saved specimen");
}
