/** Whether any piece of what was is another now: plain data is replaced, never altered in place. */
export function changed(before: readonly unknown[] = [], now: readonly unknown[] = []): boolean {
	return before.length !== now.length || now.some((each, index) => !Object.is(each, before[index]));
}
