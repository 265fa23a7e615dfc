import { linkOf, notInLink } from "./address";
import { text } from "./messages.generated";
import { SHARE } from "./parts/late_parts";
import { openPart } from "./parts/open_part";
import type { Studio } from "./studio";

/** Copies the link and notifies of parts that it does not hold; opens the share sheet if the clipboard is denied. */
export async function copyLink(studio: Studio): Promise<void> {
	const { model, specimen, fault } = studio.state;
	const link = await linkOf(model, specimen);
	const remarks = [...(fault ? [text("link_has_error")] : []), ...notInLink(model, specimen)];
	try {
		await navigator.clipboard.writeText(link);
		studio.notify(text("link_copied"), remarks, { topic: "link", brief: remarks.length === 0 });
	} catch {
		await openPart(studio, SHARE);
	}
}
