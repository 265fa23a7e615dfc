/** CanvasInteraction a file to the browser's downloads. */
export function saveFile(blob: Blob, name: string): void {
	const anchor = document.createElement("a");
	anchor.href = URL.createObjectURL(blob);
	anchor.download = name;
	anchor.click();
	// The download has taken its own hold of the data by then.
	setTimeout(() => URL.revokeObjectURL(anchor.href), 60_000);
}
