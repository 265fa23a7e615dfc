import { html } from "lit";
import { SHORTCUTS } from "../shortcuts";
import type { Studio } from "../studio";
import { VERSION } from "../version";
import { StudioElement } from "./studio_element";

/** What this is, whose paper it follows, and the keys. */
export class Help extends StudioElement {
	protected override draw(_studio: Studio): unknown {
		return html`<dialog class="help" aria-labelledby="help-title">
			<h2 id="help-title">Panicle</h2>
			<p>
				Drag the handles of a grape bunch and it regrows from its botanical grammar. The address bar always holds the
				bunch: the link is the file. What you export is yours.
			</p>
			<p>
				After C.-Y. Huang, W.-T. Jheng, W.-K. Tai, C.-C. Chang and D.-L. Way, “Procedural grape bunch modeling”,
				<i>Computers &amp; Graphics</i> 37 (2013).
			</p>
			<h3>Keys</h3>
			<dl>${SHORTCUTS.map(({ keys, does }) => html`<dt>${keys.map((key) => html`<kbd>${key}</kbd> `)}</dt><dd>${does}</dd>`)}</dl>
			<h3>Files</h3>
			<p>Drop a GLB or JSON that Panicle made anywhere on the page, or choose <i>Open…</i>, and its bunch comes back.</p>
			<p>Version ${VERSION}. The program is free under the MIT licence; titles are set in EB Garamond (SIL Open Font License).</p>
			<form method="dialog"><button class="button wine">Close</button></form>
		</dialog>`;
	}

	/** Opens the dialog; the browser keeps the focus in it and gives it back. */
	open(): void {
		this.querySelector("dialog")?.showModal();
	}
}

customElements.define("panicle-help", Help);
