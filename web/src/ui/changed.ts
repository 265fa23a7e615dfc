/** Returns whether any value differs. Data are replaced and never modified in place, so identity is compared. */
export function changed(before: readonly unknown[] = [], now: readonly unknown[] = []): boolean {
	return before.length !== now.length || now.some((each, index) => !Object.is(each, before[index]));
}
