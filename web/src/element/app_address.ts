const script = import.meta.url;
/**
 * Address of the app, relative to this script; built scripts are in a folder of the app. The npm package has no app.
 */
const beside = { development: "/", production: "../" }[import.meta.env.MODE];
const own = beside === undefined ? undefined : new URL(beside, script);

/**
 * Returns the address of the app's folder, ending in a slash; the attribute `app` overrides it. Undefined if the
 * attribute is empty or no HTTP address: a link to `javascript:` would run as a script of the page.
 */
export function appAddress(attribute: string | null): string | undefined {
	if (attribute === null) return own?.href;
	const base = own ?? document.baseURI;
	if (attribute === "" || !URL.canParse(attribute, base)) return undefined;
	const { href, protocol } = new URL(attribute, base);
	return protocol === "http:" || protocol === "https:" || protocol === own?.protocol ? href : undefined;
}
