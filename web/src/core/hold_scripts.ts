/** Keeps the scripts of an open page or frame available while newer versions of the app are installed. */

/**
 * Holds a lock by the address of a script for as long as the page lives. The service worker keeps every build that has
 * the script (offline/cached_app.ts), so that scripts which the page has not fetched yet are still available after an
 * update.
 */
export function holdScripts(script: string): void {
	// Pages without a secure address have no locks, and sandboxed frames may not request one.
	navigator.locks?.request(script, { mode: "shared" }, () => new Promise(() => {})).catch(() => {});
}
