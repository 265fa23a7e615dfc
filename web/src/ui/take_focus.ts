/** Gives an element the focus of a button that goes with what `where` finds, or has gone already. */
export function takeFocus(element: HTMLElement, where: string): void {
	const focused = document.activeElement;
	if (focused === document.body || focused?.closest(where)) element.focus({ preventScroll: true });
}
