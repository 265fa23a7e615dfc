/**
 * Makes links within the page move the focus without changing the address: its fragment may hold a document's text.
 * @returns a function that stops listening
 */
export function listenForSkips(page: Document = document): () => void {
	const listener = (event: MouseEvent) => {
		const link = (event.target as Element).closest?.<HTMLAnchorElement>("a[href^='#']");
		const place = link && page.getElementById(link.hash.slice(1));
		if (!place) return;
		event.preventDefault();
		place.focus();
	};
	page.addEventListener("click", listener);
	return () => page.removeEventListener("click", listener);
}
