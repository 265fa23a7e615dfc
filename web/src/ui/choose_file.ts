import { html } from "lit";

export interface FileChoice {
	/** Value of the input's `accept`. */
	readonly accept: string;
	/** Accessible name of the input. */
	readonly label: string;
	/** Label of the button. */
	readonly caption: string;
	take(file: File): void;
}

/** Draws a button that opens the file picker. */
export function chooseFile({ accept, label, caption, take }: FileChoice): unknown {
	const choose = (event: Event) => ((event.currentTarget as Element).previousElementSibling as HTMLElement).click();
	const chosen = (event: Event) => {
		const input = event.currentTarget as HTMLInputElement;
		const file = input.files?.[0];
		input.value = ""; // the same file may be chosen again
		if (file) take(file);
	};
	return html`<input type="file" hidden accept=${accept} aria-label=${label} @change=${chosen}>
		<button class="button" type="button" @click=${choose}>${caption}</button>`;
}
