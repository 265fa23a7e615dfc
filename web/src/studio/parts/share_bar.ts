import { html } from "lit";
import { linkOf } from "../address";
import { ACCEPT, openFile } from "../files/open";
import type { Studio } from "../studio";
import { isDark } from "../theme";
import { icon } from "./icons";
import { StudioElement } from "./studio_element";
import "./download_menu";

/** Open, copy the link, download, theme and help. */
export class ShareBar extends StudioElement {
	protected override draw(studio: Studio): unknown {
		const dark = isDark(studio.state.ui.theme);
		return html`<input type="file" hidden accept=${ACCEPT} @change=${this.#picked}>
			<button class="button quiet" type="button" aria-label="Open…" title="Open a GLB or JSON made here" @click=${this.#pick}>
				${icon("open")}<span class="words">Open…</span>
			</button>
			<button class="button quiet" type="button" aria-label="Copy link" title="Copy the link that brings this bunch back" @click=${() => copyLink(studio)}>
				${icon("link")}<span class="words">Copy link</span>
			</button>
			<panicle-download class="menu-anchor" .studio=${studio}></panicle-download>
			<button
				class="button quiet icon" type="button" aria-label=${dark ? "Light theme" : "Dark theme"} title=${dark ? "Light theme" : "Dark theme"}
				@click=${() => studio.setUi({ theme: dark ? "light" : "dark" })}
			>${icon(dark ? "light" : "dark")}</button>
			<button
				class="button quiet icon" type="button" aria-label="Help" title="About, and the keys (?)"
				@click=${() => this.dispatchEvent(new CustomEvent("panicle-help", { bubbles: true }))}
			>${icon("help")}</button>`;
	}

	#pick(): void {
		this.querySelector<HTMLInputElement>("input[type=file]")?.click();
	}

	#picked(event: Event): void {
		const input = event.target as HTMLInputElement;
		const file = input.files?.[0];
		if (file) void openFile(this.studio, file);
		input.value = ""; // The same file may be chosen again.
	}
}

/** Copies, and says so; where the clipboard is denied, the link is shown for copying by hand. */
async function copyLink(studio: Studio): Promise<void> {
	const link = await linkOf(studio.state.specimen);
	try {
		await navigator.clipboard.writeText(link);
		studio.notify("Link copied", [], { brief: true });
	} catch {
		studio.notify("The browser did not let the page copy; here is the link:", [], { copy: link });
	}
}

customElements.define("panicle-share", ShareBar);
