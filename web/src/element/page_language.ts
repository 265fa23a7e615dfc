/** The language of a page's plants. */
import { preferredLanguage, useLanguage } from "../locale/locale";

let loading: Promise<void> | undefined;

/**
 * Loads the language of the `lang` attribute nearest to the page's first plant, once a page, and before its models,
 * whose tables are in the language. English needs no request.
 */
export function loadPageLanguage(element: Element): Promise<void> {
	const tag = element.closest("[lang]")?.getAttribute("lang") ?? document.documentElement.lang;
	loading ??= useLanguage(preferredLanguage([tag]));
	return loading;
}
