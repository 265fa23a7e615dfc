import { IndexedStore } from "./indexed_store";
import { Library } from "./library";

let own: Library | undefined;

/**
 * Returns the page's library, stored in this browser and shared by all tabs. Leaving the page with specimens not stored
 * needs confirmation.
 */
export function ownLibrary(): Library {
	if (own) return own;
	const library = new Library(new IndexedStore(), new BroadcastChannel("panicle.saved"));
	addEventListener("beforeunload", (event) => {
		if (library.unstored.length > 0) event.preventDefault();
	});
	own = library;
	return library;
}

/**
 * Requests persistent storage, which the browser does not clear on a full disk. Most browsers decide by themselves;
 * some show a prompt.
 */
export async function requestPersistence(): Promise<void> {
	await navigator.storage?.persist?.().catch(() => false);
}
