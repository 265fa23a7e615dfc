/** Saves a file in the browser's downloads: clicks a link to its data. */
export function saveFile(blob: Blob, name: string): void {
	const anchor = document.createElement("a");
	anchor.href = URL.createObjectURL(blob);
	anchor.download = name;
	anchor.click();
	// By then the download has its own reference to the data.
	setTimeout(() => URL.revokeObjectURL(anchor.href), 60_000);
}
