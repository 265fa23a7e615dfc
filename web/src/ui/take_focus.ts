/** Focuses an element if the focused button is inside `where`, or was removed. */
export function takeFocus(element: HTMLElement, where: string): void {
	const focused = document.activeElement;
	if (focused === document.body || focused?.closest(where)) element.focus({ preventScroll: true });
}
