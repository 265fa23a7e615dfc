import { html } from "lit";
import { icon } from "../../ui/icons";
import { ACCEPT } from "../files/accepted_types";
import { takeFile } from "../files/drops";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { DOWNLOADS, PALETTE, SHARE } from "./late_parts";
import { openPart } from "./open_part";
import { StudioPart } from "./studio_part";

/** The buttons Search everything, Open, Share, Download, theme and Help. */
export class ShareBar extends StudioPart {
	/** Returns the values whose change redraws the bar. */
	protected override shows({ state: { dark, shown } }: Studio): readonly unknown[] {
		return [dark, shown !== undefined];
	}

	/** Renders buttons to search everything, open a file, share, download, switch the theme and open the help. */
	protected override draw(studio: Studio): unknown {
		const { dark, shown } = studio.state;
		const theme = text(dark ? "theme_light" : "theme_dark");
		return html`<input type="file" hidden accept=${ACCEPT} @change=${this.#picked}>
			<button
				class="button quiet icon" type="button" aria-label=${text("palette")} title=${text("palette_title")} aria-haspopup="dialog"
				aria-keyshortcuts="Control+K Meta+K" @click=${() => void openPart(studio, PALETTE)}
			>${icon("search")}</button>
			<button class="button quiet" type="button" aria-label=${text("open")} title=${text("open_title")} @click=${this.#pick}>
				${icon("open")}<span class="words">${text("open")}</span>
			</button>
			<button
				class="button quiet" type="button" aria-label=${text("share")} title=${text("share_title")} aria-haspopup="dialog"
				@click=${() => void openPart(studio, SHARE)}
			>${icon("share")}<span class="words">${text("share")}</span></button>
			<button
				class="button wine" type="button" aria-label=${text("download")} title=${text("download_title")} aria-haspopup="dialog"
				?disabled=${!shown} @click=${() => void openPart(studio, DOWNLOADS)}
			>${icon("download")}<span class="words">${text("download")}</span></button>
			<button
				class="button quiet icon theme" type="button" aria-label=${theme} title=${theme}
				@click=${() => studio.setUi({ theme: dark ? "light" : "dark" })}
			>${icon(dark ? "light" : "dark")}</button>
			<button
				class="button quiet icon" type="button" aria-label=${text("help")} title=${text("help_title")}
				@click=${() => this.dispatchEvent(new CustomEvent("panicle-help", { bubbles: true }))}
			>${icon("help")}</button>`;
	}

	/** Opens the browser's choice of a file. */
	#pick(): void {
		this.querySelector<HTMLInputElement>("input[type=file]")?.click();
	}

	/** Opens the chosen file. */
	#picked(event: Event): void {
		const input = event.target as HTMLInputElement;
		const file = input.files?.[0];
		if (file) void takeFile(this.context, file);
		input.value = ""; // The same file may be chosen again.
	}
}

customElements.define("panicle-share", ShareBar);
