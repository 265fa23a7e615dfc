import { html, nothing } from "lit";
import { shortcuts } from "../shortcut_list";
import type { Studio } from "../studio";
import { VERSION } from "../version";
import { StudioPart } from "./studio_part";

/** The help dialog: about the app and the model, keyboard shortcuts, files. */
export class Help extends StudioPart {
	protected override shows({ state: { model, modelUi, ui } }: Studio): readonly unknown[] {
		return [model, modelUi, ui.letters];
	}

	protected override draw({ state }: Studio): unknown {
		return html`<dialog class="help" aria-labelledby=${this.idOf("title")}>
			<h2 id=${this.idOf("title")} tabindex="-1" autofocus>Panicle</h2>
			${state.modelUi?.about}
			<p>The address bar always holds the ${state.model.noun}: the link is the file. What you export is yours.</p>
			${state.model.preview ? html`<p>The ${state.model.noun} is a preview: what its links mean may still change.</p>` : nothing}
			<h3>Keys</h3>
			<dl>${shortcuts(state).map(({ keys, does }) => html`<dt>${keys.map((key) => html`<kbd>${key}</kbd> `)}</dt><dd>${does}</dd>`)}</dl>
			<label class="toggle">
				<input type="checkbox" role="switch" .checked=${state.ui.letters} @change=${this.#switchLetters}> Single letters are keys
			</label>
			<h3>Files</h3>
			<p>Drop a GLB, a JSON or a picture that Panicle made anywhere on the page, or choose <i>Open…</i>, and its plant comes back. A grammar’s text (<code>.lsys</code>, <code>.gl3</code>, <code>.growth</code>, <code>.stand</code>) grows.</p>
			<p><i>Saved…</i> keeps plants under names of your own, in this browser only, and exports them as one file.</p>
			<p>Version ${VERSION}. The program is free under the MIT licence; titles are set in EB Garamond (SIL Open Font License).</p>
			<form method="dialog"><button class="button wine">Close</button></form>
		</dialog>`;
	}

	/** Single-letter shortcuts can be disabled: speech input triggers them by accident. */
	#switchLetters(event: Event): void {
		this.context.setUi({ letters: (event.target as HTMLInputElement).checked });
	}

	/** Opens the dialog with the focus on its heading, since the first control is far below; the browser traps and restores the focus. */
	open(): void {
		this.querySelector("dialog")?.showModal();
	}
}

customElements.define("panicle-help", Help);
