import { html } from "lit";
import { icon } from "../../ui/icons";
import { text } from "../messages.generated";

/**
 * Renders the header of a sheet: its title, and a button that closes the dialog.
 * @param id of the title
 */
export function sheetHeader(id: string, title: string): unknown {
	const close = ({ target }: Event) => (target as HTMLElement).closest("dialog")?.close();
	return html`<header>
		<h2 id=${id}>${title}</h2>
		<button class="button quiet icon" type="button" aria-label=${text("close")} @click=${close}>${icon("close")}</button>
	</header>`;
}
