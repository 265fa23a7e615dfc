/** Opens a link with a packed fragment, which is unpacked asynchronously while the page is in use. */
import type { Restored } from "../specimen/restore";
import { text } from "./messages.generated";
import type { Studio } from "./studio";
import { fetchFailed } from "./types";

/**
 * Opens a link once it is unpacked. If the document has been changed meanwhile, it stays, and a notice offers to open
 * the link.
 * @param whole the document of the link; rejects if the script that unpacks it cannot be fetched
 * @throws errors of opening the document, which are no connection errors
 */
export async function openLate(studio: Studio, whole: Promise<Restored>): Promise<void> {
	const { history, model } = studio.state;
	const restored = await whole.catch(() => undefined);
	if (!restored) {
		studio.notify(text("link_incomplete"), fetchFailed());
		return;
	}
	if (studio.state.history === history) {
		studio.open(restored, "link");
		return;
	}
	const open = () => studio.take(model, restored, "link");
	studio.notify(text("link_late"), [text("link_late_details")], { act: { label: text("link_open"), run: open } });
}
