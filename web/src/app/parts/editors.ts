import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { allBut } from "../../specimen/all_but";
import { icon } from "../../ui/icons";
import type { Tool } from "../../ui/tool";
import { text } from "../messages.generated";
import { applying, runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import { SOLID } from "../ui_state";
import { StudioPart } from "./studio_part";

/** Returns the tools that have a flat view for this specimen. */
export function editorsOf({ modelUi, specimen }: Pick<StudioState, "modelUi" | "specimen">): readonly Tool[] {
	return applying(modelUi?.tools, specimen).filter(({ editor }) => editor);
}

/** Returns the view that a phone shows: the name of a tool with a flat view, or SOLID. */
export function viewOf(state: Pick<StudioState, "modelUi" | "specimen" | "ui">): string {
	const { view } = state.ui;
	return editorsOf(state).some(({ name }) => name === view) ? view : SOLID;
}

/**
 * The model's flat views with their handles, at the left of the 3-D view; on a phone one of them replaces it. On larger
 * screens a button enlarges one of them: it changes places with the 3-D view until Escape, or the button again.
 */
export class Editors extends StudioPart {
	/** The view that the user has enlarged: the names of its model and its tool. */
	#enlarged: { readonly model: string; readonly name: string } | undefined;

	/** Starts to listen for Escape. */
	override connectedCallback(): void {
		super.connectedCallback();
		window.addEventListener("keydown", this.#escape);
	}

	/** Stops listening. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		window.removeEventListener("keydown", this.#escape);
	}

	/** Returns the state that the editors depend on; they are rendered again when one of it changes. */
	protected override shows({ state }: Studio): readonly unknown[] {
		const { model, modelUi, tools, grown, grownFrom } = state;
		return [
			model,
			modelUi,
			tools,
			grown,
			grownFrom,
			viewOf(state),
			...allBut(state.specimen, runningBy(modelUi?.tools)),
		];
	}

	/** Renders all flat editors of the model; only the chosen one is visible on a phone, and only an enlarged one. */
	protected override draw(studio: Studio): unknown {
		const view = viewOf(studio.state);
		const enlarged = this.#shownEnlarged(studio);
		const { model } = studio.state;
		return repeat(
			editorsOf(studio.state),
			({ name }) => `${model.name} ${name}`,
			({ name, editor }) => html`<section
				class="editor" data-editor=${name} ?data-shown=${name === view} ?data-enlarged=${name === enlarged}
				aria-label=${text("view_flat", { view: editor?.title ?? "" })}
			>
				<header><h2>${editor?.title}</h2>${this.#button(name, editor?.title ?? "", name === enlarged)}</header>
				${editor?.draw(studio) ?? nothing}
			</section>`,
		);
	}

	/** Renders the button that enlarges a view, or reduces the enlarged one. */
	#button(name: string, view: string, isEnlarged: boolean): unknown {
		const label = text(isEnlarged ? "view_reduce" : "view_enlarge", { view });
		return html`<button
			class="button quiet icon" type="button" aria-label=${label} title=${label}
			aria-keyshortcuts=${isEnlarged ? "Escape" : nothing} @click=${() => this.#enlarge(isEnlarged ? undefined : name)}
		>${icon(isEnlarged ? "reduce" : "enlarge")}</button>`;
	}

	/** Marks the page while a view is enlarged. */
	protected override updated(): void {
		const enlarged = this.#shownEnlarged(this.context);
		this.closest(".studio")?.toggleAttribute("data-enlarged", enlarged !== undefined);
	}

	/**
	 * Returns the name of the enlarged view; undefined if there is none, or if the plant that is shown does not have it.
	 */
	#shownEnlarged({ state }: Studio): string | undefined {
		const enlarged = this.#enlarged;
		if (enlarged?.model !== state.model.name) return undefined;
		return editorsOf(state).some(({ name }) => name === enlarged.name) ? enlarged.name : undefined;
	}

	/** Enlarges a view; undefined reduces the enlarged one. */
	#enlarge(name: string | undefined): void {
		this.#enlarged = name === undefined ? undefined : { model: this.context.state.model.name, name };
		this.requestUpdate();
	}

	/** Reduces the enlarged view by Escape, unless something else has used the key. */
	readonly #escape = (event: KeyboardEvent): void => {
		if (event.key !== "Escape" || event.defaultPrevented || document.querySelector("dialog[open]")) return;
		if (!this.context || this.#shownEnlarged(this.context) === undefined) return;
		event.preventDefault();
		this.#enlarge(undefined);
	};
}

customElements.define("panicle-editors", Editors);
