/** Callbacks for changes of the page around an element: size, scrolling, colour scheme. */
export interface Presence {
	resized(): void;
	/** Whether the element is in the viewport or near it. */
	near(is: boolean): void;
	/** Whether any part of the element is in the viewport. */
	seen(is: boolean): void;
	darkened(): void;
}

/** Distance from the viewport at which lazy plants begin to grow. */
const NEAR = "256px";

/** Observes an element and calls back until the signal aborts. */
export function watchPresence(element: HTMLElement, callbacks: Presence, signal: AbortSignal): void {
	const observers = [
		new ResizeObserver(() => callbacks.resized()),
		new IntersectionObserver((entries) => callbacks.near(isSeen(entries)), { rootMargin: NEAR }),
		new IntersectionObserver((entries) => callbacks.seen(isSeen(entries))),
	];
	for (const observer of observers) observer.observe(element);
	signal.addEventListener("abort", () => {
		for (const observer of observers) observer.disconnect();
	});
	matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => callbacks.darkened(), { signal });
}

/** Returns whether the last entry reports an element in view. */
const isSeen = (entries: readonly IntersectionObserverEntry[]) => entries.at(-1)?.isIntersecting ?? false;

/**
 * Returns whether an element is dark.
 * @param theme its attribute: `light`, `dark`, or any other value for the system's scheme
 */
export function isDark(theme: string | null): boolean {
	return theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
}
