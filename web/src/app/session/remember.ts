/** Records the plants of this page and its undo history; loaded once the first plant is drawn. */

import { ownRecents } from "../recent/recents";
import { RecentRecorder } from "../recent/recorder";
import { thumbnailOf } from "../saved/thumbnail";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import { restoreHistory, storeHistory, type TabStorage } from "./tab_history";

export async function remember(studio: Studio): Promise<void> {
	const storage = tabStorage();
	// First, because it may add parts to the plant that the address could not hold.
	if (storage) await restoreHistory(studio, storage).catch(() => {});
	const recorder = new RecentRecorder(studio, ownRecents(), { thumbnail });
	recorder.start();
	const store = () => {
		if (storage) storeHistory(studio, storage);
	};
	document.addEventListener("visibilitychange", () => {
		if (document.visibilityState !== "hidden") return;
		void recorder.flush();
		store();
	});
	addEventListener("pagehide", () => {
		recorder.defer();
		store();
	});
}

/** Returns the storage of this tab; undefined where it is forbidden. */
function tabStorage(): TabStorage | undefined {
	try {
		return sessionStorage;
	} catch {
		return undefined;
	}
}

/** Makes a small picture when the browser is idle. */
async function thumbnail(take: NonNullable<StudioState["picture"]>): Promise<Uint8Array<ArrayBuffer>> {
	await new Promise<unknown>((resolve) =>
		"requestIdleCallback" in window ? requestIdleCallback(resolve, { timeout: 500 }) : setTimeout(resolve),
	);
	return thumbnailOf(take);
}
