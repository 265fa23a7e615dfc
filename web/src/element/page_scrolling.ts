/**
 * Scrolling of the page over the view: the wheel and one finger scroll the page; the wheel with Ctrl or ⌘, and two
 * fingers, zoom the plant. An element with the attribute `capture`, or in full screen, takes all of them.
 */

/** Listens to the canvas of an element until the signal aborts, before the listeners of the camera do. */
export function leaveScrollingToPage(canvas: HTMLCanvasElement, signal: AbortSignal): void {
	const root = canvas.getRootNode() as ShadowRoot;
	/** Whether the pointer has moved over the plant since the page last scrolled under it. */
	let isPointing = false;
	canvas.addEventListener("pointermove", () => (isPointing = true), { signal });
	const wheel = (event: WheelEvent) => {
		if (event.ctrlKey || event.metaKey || root.host.matches("[capture], :fullscreen")) return;
		// The camera does not get the event, so that the browser scrolls the page.
		event.stopPropagation();
		if (isPointing) import("./extras/zoom_hint").then(({ showZoomHint }) => showZoomHint(root)).catch(() => {});
		isPointing = false;
	};
	canvas.addEventListener("wheel", wheel, { signal, capture: true, passive: true });
	// Otherwise the browser scrolls the page with two fingers, too (`touch-action: pan-y`), and ends their pointer events.
	const touch = (event: TouchEvent) => {
		if (event.targetTouches.length > 1 && event.cancelable) event.preventDefault();
	};
	canvas.addEventListener("touchmove", touch, { signal, passive: false });
}
