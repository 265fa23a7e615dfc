import { html, nothing } from "lit";
import { shortcuts } from "../shortcut_list";
import type { Studio } from "../studio";
import { VERSION } from "../version";
import { StudioPart } from "./studio_part";

/** What this is, what the model says of itself, and the keys. */
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

	/** Some press letters without meaning to: speech input does. */
	#switchLetters(event: Event): void {
		this.context.setUi({ letters: (event.target as HTMLInputElement).checked });
	}

	/** Opens the dialog at its heading, for the first thing to press is far below; the browser keeps the focus in it and gives it back. */
	open(): void {
		this.querySelector("dialog")?.showModal();
	}
}

customElements.define("panicle-help", Help);
