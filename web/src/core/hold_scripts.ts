/** Keeps the scripts of an open page, or frame, while newer versions of the app come. */

/**
 * Holds a lock by the address of a script for as long as the page lives. The service worker keeps every build that has the script
 * (offline/kept_app.ts), so that what the page has yet to fetch is still there after an update.
 */
export function holdScripts(script: string): void {
	// Pages without a secure address have no locks, and sandboxed frames may not request one.
	navigator.locks?.request(script, { mode: "shared" }, () => new Promise(() => {})).catch(() => {});
}
