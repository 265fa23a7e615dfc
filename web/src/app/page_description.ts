/** The title, the description and the picture of the page, for browsers, search engines and previews of links. */

/** The description of a page. */
export interface PageDescription {
	/** The title of the tab. */
	readonly title: string;
	/** One or two sentences. */
	readonly about: string;
	/** Address of a picture, relative to the page; undefined leaves the picture. */
	readonly picture?: string | undefined;
}

/** Writes the description into the document's head. */
export function describePage({ title, about, picture }: PageDescription): void {
	document.title = title;
	setMeta("name", "description", about);
	setMeta("property", "og:title", title);
	setMeta("property", "og:description", about);
	if (picture !== undefined) setMeta("property", "og:image", new URL(picture, document.baseURI).href);
}

/** Sets the content of a meta element, which is added where it is missing. */
function setMeta(attribute: "name" | "property", key: string, content: string): void {
	let meta = document.head.querySelector(`meta[${attribute}="${key}"]`);
	if (!meta) {
		meta = document.createElement("meta");
		meta.setAttribute(attribute, key);
		document.head.append(meta);
	}
	meta.setAttribute("content", content);
}
