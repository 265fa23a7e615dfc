/** What a page does with an element: sizes it, scrolls it near and into sight, turns dark. */
export interface Presence {
	resized(): void;
	/** Whether it is on screen, or nearly. */
	near(is: boolean): void;
	/** Whether any of it is on screen. */
	seen(is: boolean): void;
	darkened(): void;
}

/** How far off screen what is lazy begins to grow. */
const NEAR = "256px";

/** Tells of it until the signal ends that. */
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

const isSeen = (entries: readonly IntersectionObserverEntry[]) => entries.at(-1)?.isIntersecting ?? false;

/** @param theme what the element says: `light`, `dark`, or nothing of its own */
export function isDark(theme: string | null): boolean {
	return theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
}
