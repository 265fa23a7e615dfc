import { html } from "lit";
import type { ParameterEntry } from "../specimen/table";
import type { EditorContext } from "./editor_context";
import "./choice";
import "./colour";
import "./number";
import { isQuantity } from "./quantity";

/** Returns the control of a parameter. */
export function control(context: EditorContext, entry: ParameterEntry): unknown {
	if (entry.kind === "colour") return html`<panicle-colour .context=${context} .entry=${entry}></panicle-colour>`;
	if (entry.kind === "choice") return html`<panicle-choice .context=${context} .entry=${entry}></panicle-choice>`;
	if (isQuantity(entry)) return html`<panicle-quantity .context=${context} .entry=${entry}></panicle-quantity>`;
	return html`<panicle-number .context=${context} .entry=${entry}></panicle-number>`;
}
