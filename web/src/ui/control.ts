import { html } from "lit";
import type { Entry } from "../specimen/table";
import type { EditorContext } from "./editor_context";
import "./choice";
import "./colour";
import "./number";

/** The control that suits a parameter. */
export function control(desk: EditorContext, entry: Entry): unknown {
	if (entry.kind === "colour") return html`<panicle-colour .desk=${desk} .entry=${entry}></panicle-colour>`;
	if (entry.kind === "choice") return html`<panicle-choice .desk=${desk} .entry=${entry}></panicle-choice>`;
	return html`<panicle-number .desk=${desk} .entry=${entry}></panicle-number>`;
}
