import { html } from "lit";
import { text as appText } from "../messages.generated";
import { sheetHeader } from "../parts/sheet_header";
import { StudioPart } from "../parts/studio_part";
import type { Studio } from "../studio";
import { text } from "./messages.generated";
import { type ShortcutGroup, shortcutGroups } from "./shortcut_list";
import "../style/sheets.css";
import "../style/help.css";

/** The dialog that lists the keyboard shortcuts, with the switch for single letters. */
export class ShortcutSheet extends StudioPart {
	/** Returns the values whose change redraws the sheet. */
	protected override shows({ state: { modelUi, ui } }: Studio): readonly unknown[] {
		return [modelUi, ui.letters];
	}

	/** Renders the groups of shortcuts and the switch. */
	protected override draw({ state }: Studio): unknown {
		return html`<dialog class="help sheet-dialog shortcuts" closedby="any" aria-labelledby=${this.idOf("title")}>
			${sheetHeader(this.idOf("title"), appText("shortcuts"))}
			<label class="toggle">
				<input
					type="checkbox" role="switch" .checked=${state.ui.letters} aria-describedby=${this.idOf("about")} @change=${this.#switchLetters}
				> ${text("letters")}
			</label>
			<p id=${this.idOf("about")}>${text("shortcuts_about")}</p>
			<div class="shortcut-groups">${shortcutGroups(state).map((group) => this.#group(group))}</div>
		</dialog>`;
	}

	/** Renders the shortcuts of a group. */
	#group({ key, shortcuts }: ShortcutGroup): unknown {
		const title = this.idOf(key);
		return html`<section aria-labelledby=${title}>
			<h3 id=${title}>${text(`group_${key}`)}</h3>
			<dl>${shortcuts.map(
				({ keys, description }) => html`<div>
					<dt>${keys.map((each) => html`<kbd>${each}</kbd> `)}</dt><dd>${description}</dd>
				</div>`,
			)}</dl>
		</section>`;
	}

	/** Turns single-letter shortcuts on or off, because speech input triggers them by accident. */
	#switchLetters(event: Event): void {
		this.context.setUi({ letters: (event.target as HTMLInputElement).checked });
	}

	/** Opens the dialog, with the focus on the button that closes it; the browser traps and restores the focus. */
	async open(): Promise<void> {
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
	}
}

customElements.define("panicle-shortcuts", ShortcutSheet);
