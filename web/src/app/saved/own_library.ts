import { IndexedStore } from "./indexed_store";
import { Library } from "./library";

let own: Library | undefined;

/** The page's library: in this browser, the same in all tabs. Whoever leaves the page with something unkept is asked. */
export function ownLibrary(): Library {
	if (own) return own;
	const library = new Library(new IndexedStore(), new BroadcastChannel("panicle.saved"));
	addEventListener("beforeunload", (event) => {
		if (library.unstored.length > 0) event.preventDefault();
	});
	own = library;
	return library;
}

/** Asks the browser not to clear what is kept where the disk runs low. Most decide by themselves; some ask the person. */
export async function requestPersistence(): Promise<void> {
	await navigator.storage?.persist?.().catch(() => false);
}
