const script = import.meta.url;
/** Where the app is that the element came with: built scripts lie in a folder of it. None came with the package. */
const beside = { development: "/", production: "../" }[import.meta.env.MODE];
const own = beside === undefined ? undefined : new URL(beside, script);

/**
 * The address of the app's folder, with its last slash. The attribute `app` names another; none where it is empty or not an address of
 * HTTP: a link to `javascript:` would run as a script of the page.
 */
export function appAddress(attribute: string | null): string | undefined {
	if (attribute === null) return own?.href;
	const base = own ?? document.baseURI;
	if (attribute === "" || !URL.canParse(attribute, base)) return undefined;
	const { href, protocol } = new URL(attribute, base);
	return protocol === "http:" || protocol === "https:" || protocol === own?.protocol ? href : undefined;
}
