/** The plants that were open in this browser lately, as the palette offers them. */
import { svg } from "lit";
import { encodeLink } from "../../specimen/link";
import { openRecent } from "../recent/open_recent";
import { ownRecents, type Recents } from "../recent/recents";
import { timeInWords } from "../recent/time_in_words";
import type { Studio } from "../studio";
import type { PaletteEntry } from "./entries";

const CLOCK = svg`<circle cx="10" cy="10" r="7"/><path d="M10 6v4l3 2"/>`;

/** Returns the entries of the recent plants, newest first, without the one that is open. */
export async function recentPlantEntries(
	studio: Studio,
	recents: Pick<Recents, "all"> = ownRecents(),
): Promise<readonly PaletteEntry[]> {
	const { model, specimen } = studio.state;
	const [plants, open] = await Promise.all([recents.all(), encodeLink(model, specimen)]);
	const now = Date.now();
	return plants
		.filter(({ link }) => link !== open)
		.map((plant) => ({
			key: `recent:${plant.id}`,
			group: "plants",
			title: plant.title,
			about: timeInWords(plant, now),
			icon: CLOCK,
			texts: { title: plant.title },
			run: () => openRecent(studio, plant),
		}));
}
