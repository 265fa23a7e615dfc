import { html } from "lit";
import { icon } from "../../ui/icons";
import { linkOf, notInLink } from "../address";
import { ACCEPT, takeFile } from "../files/drops";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "./download_menu";

/** The buttons Open, Copy link, Download, theme and Help. */
export class ShareBar extends StudioPart {
	protected override shows({ state: { dark, model } }: Studio): readonly unknown[] {
		return [dark, model];
	}

	protected override draw(studio: Studio): unknown {
		const { dark, model } = studio.state;
		return html`<input type="file" hidden accept=${ACCEPT} @change=${this.#picked}>
			<button class="button quiet" type="button" aria-label="Open…" title="Open a GLB, JSON or PNG made here, or a grammar (.lsys)" @click=${this.#pick}>
				${icon("open")}<span class="words">Open…</span>
			</button>
			<button class="button quiet" type="button" aria-label="Copy link" title="Copy the link that brings this ${model.noun} back" @click=${() => copyLink(studio)}>
				${icon("link")}<span class="words">Copy link</span>
			</button>
			<panicle-download class="menu-anchor" .context=${studio}></panicle-download>
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
		if (file) void takeFile(this.context, file);
		input.value = ""; // The same file may be chosen again.
	}
}

/** Copies the link and notifies of parts that it does not hold; if the clipboard is denied, shows the link for copying by hand. */
async function copyLink(studio: Studio): Promise<void> {
	const { model, specimen, fault } = studio.state;
	const link = await linkOf(model, specimen);
	const lost = [
		...(fault ? [`Who opens it finds no ${model.noun}: this cannot be grown as it is.`] : []),
		...notInLink(model, specimen),
	];
	try {
		await navigator.clipboard.writeText(link);
		studio.notify("Link copied", lost, { topic: "link", brief: lost.length === 0 });
	} catch {
		studio.notify("The browser did not let the page copy; here is the link:", lost, { topic: "link", copy: link });
	}
}

customElements.define("panicle-share", ShareBar);
