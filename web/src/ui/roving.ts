/** Roving focus: a row of buttons is one stop of the Tab key; arrow keys, Home and End move within it. */

/** Makes one item of the row the tab stop. */
export function stopAt(row: readonly HTMLElement[], stop: HTMLElement | undefined): void {
	for (const item of row) item.tabIndex = item === stop ? 0 : -1;
}

/**
 * Moves the focus within the row by a key, and makes the target the tab stop.
 * @returns whether the focus moved
 */
export function rove(event: KeyboardEvent, row: readonly HTMLElement[]): boolean {
	const at = row.indexOf(event.target as HTMLElement);
	const next = destination(event.key, at, row.length);
	const item = next === undefined || at < 0 ? undefined : row[next];
	if (!item) return false;
	event.preventDefault();
	stopAt(row, item);
	item.focus();
	return true;
}

/**
 * Returns the index to which a key moves the focus from `at`; undefined for other keys. It may lie beyond the row's
 * ends.
 */
function destination(key: string, at: number, count: number): number | undefined {
	if (key === "ArrowRight" || key === "ArrowDown") return at + 1;
	if (key === "ArrowLeft" || key === "ArrowUp") return at - 1;
	if (key === "Home") return 0;
	return key === "End" ? count - 1 : undefined;
}
