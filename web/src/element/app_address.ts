const script = import.meta.url;
/** Where the app is that the element came with: built scripts lie in a folder of it. None came with the package. */
const beside = { development: "/", production: "../" }[import.meta.env.MODE];
const own = beside === undefined ? undefined : new URL(beside, script);

/** The address of the folder, with its last slash; an element's `app` says another, or none where it is empty. */
export function appAddress(said: string | null): string | undefined {
	if (said === null) return own?.href;
	const base = own ?? document.baseURI;
	return said !== "" && URL.canParse(said, base) ? new URL(said, base).href : undefined;
}
