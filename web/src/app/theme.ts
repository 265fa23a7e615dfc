import type { UiState } from "./ui_state";

/** Returns the query for the system's colour scheme. */
const darkSchemeQuery = () => window.matchMedia("(prefers-color-scheme: dark)");

/** Returns whether the system's colour scheme is dark. */
export function isSystemDark(): boolean {
	return darkSchemeQuery().matches;
}

/** Calls back when the system goes from light to dark or back. */
export function onSystemTheme(callback: (dark: boolean) => void): void {
	darkSchemeQuery().addEventListener("change", ({ matches }) => callback(matches));
}

/** Sets the theme of the page (`data-theme`, used by style/tokens.css) and of the browser's toolbar. */
export function applyTheme(theme: UiState["theme"]): void {
	const { dataset } = document.documentElement;
	if (theme === "system") delete dataset.theme;
	else dataset.theme = theme;
	// Colour of the browser's toolbar.
	for (const meta of document.querySelectorAll<HTMLMetaElement>("meta[name=theme-color]")) {
		const own = meta.dataset.theme;
		meta.media = theme === "system" ? `(prefers-color-scheme: ${own})` : own === theme ? "all" : "not all";
	}
}
