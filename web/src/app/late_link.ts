/** Opens a link with a packed fragment, which is unpacked asynchronously while the page is in use. */
import type { Restored } from "../specimen/restore";
import type { Studio } from "./studio";

/**
 * Opens a link once it is unpacked. If the document has been changed meanwhile, it stays, and a notice offers to open the link.
 * @param whole the document of the link; rejects if the script that unpacks it cannot be fetched
 * @throws errors of opening the document, which are no connection errors
 */
export async function openLate(studio: Studio, whole: Promise<Restored>): Promise<void> {
	const { history, model } = studio.state;
	const restored = await whole.catch(() => undefined);
	if (!restored) {
		studio.notify("The link could not be read to its end", [
			"Part of this page could not be fetched; check the connection and load the page again.",
		]);
		return;
	}
	if (studio.state.history === history) {
		studio.open(restored, "link");
		return;
	}
	const open = () => studio.take(model, restored, "link");
	const details = ["You changed the plant before the link was read to its end; your changes are kept."];
	studio.notify("The link is not opened yet", details, { act: { words: "Open the link", run: open } });
}
