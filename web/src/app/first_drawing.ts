/** The first drawing of the page, for which files wait that would delay it. */

/** Longest time that they wait; milliseconds. */
const LONGEST_WAIT = 3000;

let drawing: Promise<void> | undefined;

/** Resolves when the view has drawn its first plant, at the latest LONGEST_WAIT after the first call. */
export function firstDrawing(): Promise<void> {
	drawing ??= new Promise((resolve) => {
		new PerformanceObserver((list, observer) => {
			if (list.getEntriesByName("first-bunch").length === 0) return;
			observer.disconnect();
			resolve();
		}).observe({ type: "mark", buffered: true });
		setTimeout(resolve, LONGEST_WAIT);
	});
	return drawing;
}
