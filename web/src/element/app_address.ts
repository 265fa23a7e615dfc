/** Where the app is that the element came with: built scripts lie in a folder of it. */
const script = import.meta.url;

/** The address of the folder, with its last slash; an element's `app` says another, or none. */
export function appAddress(said: string | null): string | undefined {
	if (said === "") return undefined;
	const own = import.meta.env.DEV ? new URL("/", script) : new URL("../", script);
	return URL.canParse(said ?? "", own) ? new URL(said ?? "", own).href : undefined;
}
