import { html, nothing } from "lit";
import type { TextPlace } from "../plant/derivation_trace";
import { ControlElement } from "../ui/control_element";
import type { Stateful } from "../ui/editor_context";
import { icon } from "../ui/icons";
import { KeyRuns } from "../ui/key_runs";
import { DERIVATION } from "./derivation_tool";
import { Editor } from "./editor";
import type { Explanation } from "./explain";
import type { GrammarState } from "./grammar_tool";
import type { NumberAt } from "./outline";
import { type Problem, problemsOf } from "./reported_problems";
import { type GrammarContext, type GrammarSource, isOwn, textOf, withText } from "./source";
import type { ShownProductions } from "./stepper";
import { TypingRoom } from "./typing_room";
import "./number_pad";
import "./stepper";
import { text } from "./messages.generated";

const GESTURE = "grammar";
/** Pause in typing that ends an undo step, milliseconds. */
const PAUSE = 700;

/**
 * Messages listed below the text. Further ones are only marked in the text, because the layout of thousands of lines
 * takes seconds.
 */
const MAX_MESSAGES = 50;
/** Button that gets the focus back if a key opened the pane. */
const openerSelector = () => `.stage-tools [aria-label="${CSS.escape(text("grammar"))}"]`;

/** Editor of the grammar beside the plant: every change grows at once, and problems are marked at their places. */
export class GrammarPane extends ControlElement<GrammarContext> {
	static override properties = {
		...ControlElement.properties,
		source: { attribute: false },
		tool: { attribute: false },
		stepped: { attribute: false },
		close: { attribute: false },
		number: { state: true },
		explained: { state: true },
		production: { state: true },
	};
	declare source: GrammarSource;
	declare tool: Stateful<GrammarState>;
	/** Whether the model offers the derivation step by step. */
	declare stepped: boolean;
	declare close: () => void;
	/** Number at the cursor. */
	declare number: NumberAt | undefined;
	declare explained: Explanation | undefined;
	/** Line of the production at the cursor. */
	declare production: number | undefined;

	#editor: Editor | undefined;
	readonly #runs = new KeyRuns();
	#room: TypingRoom | undefined;
	#pause: ReturnType<typeof setTimeout> | undefined;
	/** Element that had the focus before the pane opened. */
	#opener: Element | null = null;

	/** Notes the element with the focus, and follows a phone's keyboard. */
	override connectedCallback(): void {
		super.connectedCallback();
		this.#opener = document.activeElement;
		// Runs after the page's new layout.
		this.#room = new TypingRoom(() => requestAnimationFrame(() => this.#editor?.showCursor()));
	}

	/** Ends the current edit, destroys the editor and returns the focus to the element that opened the pane. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#settle();
		this.#room?.end();
		this.#editor?.destroy();
		this.#editor = undefined;
		this.context.setToolState(DERIVATION, { ...this.context.toolState(DERIVATION), open: false });
		// Returns the focus, unless it has already moved elsewhere.
		if (document.activeElement !== document.body) return;
		const opener = this.#opener === document.body ? document.querySelector(openerSelector()) : this.#opener;
		if (opener instanceof HTMLElement) opener.focus();
	}

	/** Returns the state that the pane depends on; it is rendered again when one of them changes. */
	protected override shows({ state }: GrammarContext): readonly unknown[] {
		const { open } = this.context.toolState(DERIVATION);
		return [
			this.#text(),
			state.specimen.grammar,
			state.fault,
			state.grown?.noteMessages,
			this.context.toolState(this.tool),
			open,
		];
	}

	/** Renders the pane. Its editor is not rendered by Lit: `updated` creates it in `.pane-text`. */
	protected override draw({ state }: GrammarContext): unknown {
		const { specimen } = state;
		const own = isOwn(specimen);
		const title = this.idOf("title");
		const steps = this.idOf("steps");
		const { open } = this.context.toolState(DERIVATION);
		return html`<section class=${open ? "pane stepping" : "pane"} aria-labelledby=${title}>
			<header>
				<h2 id=${title}>${text("grammar")}</h2>
				<p>${text(own ? "own" : "built_in")}</p>
				${own ? html`<button class="button" type="button" @click=${this.#discard}>${text("discard")}</button>` : nothing}
				${
					this.stepped
						? html`<button class="button" type="button" aria-expanded=${open} aria-controls=${steps} title=${text("steps_title")} @click=${this.#toggleSteps}>
					${text("steps")}
				</button>`
						: nothing
				}
				<button
					class="button quiet icon" type="button" aria-label=${text("find")} title=${text("find_title")} aria-keyshortcuts="Control+F" @click=${() => this.#editor?.find()}
				>${icon("search")}</button>
				<button class="button quiet icon" type="button" data-close aria-label=${text("close")} title=${text("close")} @click=${this.close}>
					${icon("close")}
				</button>
			</header>
			<div class="pane-text"></div>
			<div class="pane-steps" id=${steps} role="region" aria-label=${text("derivation")} ?hidden=${!open}>
				${open ? this.#stepper() : nothing}
			</div>
			<div class="pane-messages" role="status">${this.#messages(this.#problems)}</div>
			<footer>
				<panicle-number-pad .number=${this.number} .grip=${this.#grip} .step=${this.#step} .done=${this.#settle}></panicle-number-pad>
				<p class="pane-hint">${this.#hint()}</p>
				<label class="toggle">
					<input type="checkbox" .checked=${this.context.toolState(this.tool).indents} @change=${this.#setIndents}>${text("tab_indents")}
				</label>
			</footer>
		</section>`;
	}

	/** Creates the editor once, then passes the text and its problems to it. */
	protected override updated(): void {
		const grammar = this.#text();
		// An update requested before the pane closed may run afterwards.
		if (grammar === undefined || !this.isConnected) return;
		// CodeMirror uses \n as line end.
		const shown = grammar.replace(/\r\n?/g, "\n");
		const { indents } = this.context.toolState(this.tool);
		if (!this.#editor) {
			this.#editor = this.#createEditor(shown, indents);
			if (!matchMedia("(pointer: coarse)").matches) this.#editor.focus();
		}
		this.#editor.text = shown;
		this.#editor.indents = indents;
		this.#editor.problems = this.#problems;
	}

	/** Whether the plant shown has grown from this text; else its problems would be shown at wrong places. */
	get #current(): boolean {
		const { grownFrom, specimen } = this.context.state;
		return grownFrom !== undefined && grownFrom.grammar === specimen.grammar;
	}

	/** Problems with a place in the text: the error, or the shown plant's remarks. */
	get #problems(): Problem[] {
		const { fault, grown } = this.context.state;
		return problemsOf(fault, this.#current ? (grown?.noteMessages ?? []) : []);
	}

	/** Draws the step viewer. */
	#stepper(): unknown {
		const goTo = (place: TextPlace) => this.#editor?.goTo(place);
		return html`<panicle-stepper
			.context=${this.context} .line=${this.#current ? this.production : undefined} .shown=${this.#showProductions} .goTo=${goTo}
		></panicle-stepper>`;
	}

	/** Marks the productions of the step viewer's module in the text. */
	readonly #showProductions = ({ fires, wrote }: ShownProductions): void => {
		if (!this.#editor || !this.isConnected) return;
		this.#editor.productions = this.#current ? { fires: fires?.line, wrote: wrote?.line } : {};
	};

	/** Opens or closes the step viewer. */
	readonly #toggleSteps = (): void => {
		const state = this.context.toolState(DERIVATION);
		this.context.setToolState(DERIVATION, { ...state, open: !state.open });
	};

	/** Returns the document's text; undefined while the built-in text loads, after which the pane is drawn again. */
	#text(): string | undefined {
		return textOf(this.source, this.context.state.specimen, () => this.requestUpdate());
	}

	/**
	 * Creates the editor in a shadow root of its own.
	 * @param grammar the first text
	 * @param indents whether Tab indents
	 */
	#createEditor(grammar: string, indents: boolean): Editor {
		const root = this.querySelector(".pane-text")?.attachShadow({ mode: "open" });
		const options = {
			text: grammar,
			indents,
			label: text("grammar"),
			help: text("editor_keys"),
			roles: this.source.roles ?? [],
			dialect: this.source.dialect,
		};
		return new Editor(root as ShadowRoot, options, {
			edited: (next, how) => this.#applyEdit(next, how),
			settle: () => this.#settle(),
			undo: () => this.context.undo(),
			redo: () => this.context.redo(),
			leave: () => this.#leaveEditor(),
			at: (number, explained, production) => {
				this.number = number;
				this.explained = explained;
				this.production = production;
			},
			blurred: () => this.#settle(),
		});
	}

	/**
	 * Applies an edit of the text; edits of the same kind in quick succession are one undo step.
	 * @param how kind of the edit, as `EditorEvents.edited` reports it
	 */
	#applyEdit(grammar: string, how: string): void {
		const { context } = this;
		// Growth in progress is of an outdated text.
		if (context.state.growing) context.cancel();
		const run = how.startsWith("input.scrub") ? undefined : this.#runs.press(how);
		context.edit({ ...withText(this.source, context.state.specimen, grammar), run }, GESTURE);
		clearTimeout(this.#pause);
		if (run) this.#pause = setTimeout(this.#settle, PAUSE);
	}

	/** Handles Escape: cancels a long growth, as in the whole page, or else moves the focus to the close button. */
	#leaveEditor(): void {
		if (this.context.state.growing) this.context.cancel();
		else this.querySelector<HTMLElement>("[data-close]")?.focus();
	}

	/** Ends the current undo step. */
	readonly #settle = (): void => {
		clearTimeout(this.#pause);
		this.context.settle(GESTURE);
	};

	/** Changes the number at the cursor by steps. */
	readonly #step = (steps: number): void => this.#editor?.step(steps);

	/** Begins a drag of the number at the cursor, as an undo step of its own. */
	readonly #grip = () => {
		this.#settle();
		return this.#editor?.grip();
	};

	/** Discards the document's own text. */
	readonly #discard = (): void => {
		this.context.set(withText(this.source, this.context.state.specimen, undefined));
		this.#editor?.focus();
	};

	/** Takes the state of the checkbox “Tab indents”. */
	readonly #setIndents = (event: Event): void => {
		const indents = (event.target as HTMLInputElement).checked;
		this.context.setToolState(this.tool, { ...this.context.toolState(this.tool), indents });
	};

	/** Draws the explanation of the word at the cursor, or else advice. */
	#hint(): unknown {
		const { explained } = this;
		if (!explained) return text("hint_drag");
		return html`<code>${explained.written}</code> ${explained.help}`;
	}

	/**
	 * Renders errors without a place in the text, warnings of the shown plant, and the first MAX_MESSAGES problems, each
	 * a button that goes to its place.
	 */
	#messages(problems: readonly Problem[]): unknown {
		const { fault, grown, grownFrom, specimen } = this.context.state;
		const current = grownFrom?.grammar === specimen.grammar && !fault;
		const warnings = grown && grownFrom && current ? (this.source.warnings?.(grown, grownFrom) ?? []) : [];
		const elsewhere = fault && fault.line === 0 ? html`<p class="error">${fault.message}</p>` : nothing;
		const list = problems.slice(0, MAX_MESSAGES).map(
			(problem) => html`<button type="button" class=${problem.severity} @click=${() => this.#editor?.goTo(problem)}>
				<b>${text("line_number", { line: String(problem.line) })}</b> ${problem.message}
			</button>`,
		);
		const more = problems.length - MAX_MESSAGES;
		const others = more > 0 ? html`<p class="remark">${text("more_problems", { count: more })}</p>` : nothing;
		return html`${elsewhere}${warnings.map((words) => html`<p class="remark">${words}</p>`)}${list}${others}`;
	}
}

customElements.define("panicle-grammar", GrammarPane);
