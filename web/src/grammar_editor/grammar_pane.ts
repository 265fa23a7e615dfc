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

const GESTURE = "grammar";
/** Pause in typing that ends an undo step, milliseconds. */
const PAUSE = 700;
const KEYS =
	"Alt with the arrow keys changes the number at the cursor, with Shift by ten steps, with Control by a tenth. Control and Space completes, Control and F finds. Tab goes on to what comes next, unless it is set to indent. Escape leaves the text.";

/**
 * Messages listed below the text. Further ones are only marked in the text, because the layout of thousands of lines takes seconds.
 */
const MOST_MESSAGES = 50;
/** Button that gets the focus back if a key opened the pane. */
const OPENS = ".stage-tools [aria-label=Grammar]";

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

	override connectedCallback(): void {
		super.connectedCallback();
		this.#opener = document.activeElement;
		// Runs after the page's new layout.
		this.#room = new TypingRoom(() => requestAnimationFrame(() => this.#editor?.showCursor()));
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#settle();
		this.#room?.end();
		this.#editor?.destroy();
		this.#editor = undefined;
		this.context.setToolState(DERIVATION, { ...this.context.toolState(DERIVATION), open: false });
		// Returns the focus, unless it has already moved elsewhere.
		if (document.activeElement !== document.body) return;
		const opener = this.#opener === document.body ? document.querySelector(OPENS) : this.#opener;
		if (opener instanceof HTMLElement) opener.focus();
	}

	protected override shows({ state }: GrammarContext): readonly unknown[] {
		const { open } = this.context.toolState(DERIVATION);
		return [
			this.#text(),
			state.specimen.grammar,
			state.fault,
			state.grown?.notes,
			this.context.toolState(this.tool),
			open,
		];
	}

	protected override draw({ state }: GrammarContext): unknown {
		const { noun } = this.source;
		const { specimen } = state;
		const own = isOwn(specimen);
		const title = this.idOf("title");
		const steps = this.idOf("steps");
		const { open } = this.context.toolState(DERIVATION);
		return html`<section class=${open ? "pane stepping" : "pane"} aria-labelledby=${title}>
			<header>
				<h2 id=${title}>Grammar</h2>
				<p>${own ? `This ${noun}’s own` : "Built in; a change makes it this plant’s own"}</p>
				${own ? html`<button class="button" type="button" @click=${this.#drop}>Use the built-in grammar</button>` : nothing}
				${
					this.stepped
						? html`<button class="button" type="button" aria-expanded=${open} aria-controls=${steps} title="The derivation, step by step" @click=${this.#setSteps}>
					Steps
				</button>`
						: nothing
				}
				<button
					class="button quiet icon" type="button" aria-label="Find" title="Find (Ctrl+F)" aria-keyshortcuts="Control+F" @click=${() => this.#editor?.find()}
				>${icon("search")}</button>
				<button class="button quiet icon" type="button" data-close aria-label="Close the grammar" title="Close the grammar" @click=${this.close}>
					${icon("close")}
				</button>
			</header>
			<div class="pane-text"></div>
			<div class="pane-steps" id=${steps} role="region" aria-label="Derivation" ?hidden=${!open}>
				${open ? this.#stepper() : nothing}
			</div>
			<div class="pane-messages" role="status">${this.#messages(this.#problems)}</div>
			<footer>
				<panicle-number-pad .number=${this.number} .grip=${this.#grip} .step=${this.#step} .done=${this.#settle}></panicle-number-pad>
				<p class="pane-hint">${this.#hint()}</p>
				<label class="toggle">
					<input type="checkbox" .checked=${this.context.toolState(this.tool).indents} @change=${this.#setIndents}>Tab indents
				</label>
			</footer>
		</section>`;
	}

	protected override updated(): void {
		const text = this.#text();
		// An update requested before the pane closed may run afterwards.
		if (text === undefined || !this.isConnected) return;
		// CodeMirror uses \n as line end.
		const shown = text.replace(/\r\n?/g, "\n");
		const { indents } = this.context.toolState(this.tool);
		if (!this.#editor) {
			this.#editor = this.#begin(shown, indents);
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

	get #problems(): Problem[] {
		const { fault, grown } = this.context.state;
		return problemsOf(fault, this.#current ? (grown?.notes ?? []) : []);
	}

	#stepper(): unknown {
		const goTo = (place: TextPlace) => this.#editor?.goTo(place);
		return html`<panicle-stepper
			.context=${this.context} .line=${this.#current ? this.production : undefined} .shown=${this.#showProductions} .goTo=${goTo}
		></panicle-stepper>`;
	}

	readonly #showProductions = ({ fires, wrote }: ShownProductions): void => {
		if (!this.#editor || !this.isConnected) return;
		this.#editor.productions = this.#current ? { fires: fires?.line, wrote: wrote?.line } : {};
	};

	readonly #setSteps = (): void => {
		const state = this.context.toolState(DERIVATION);
		this.context.setToolState(DERIVATION, { ...state, open: !state.open });
	};

	#text(): string | undefined {
		return textOf(this.source, this.context.state.specimen, () => this.requestUpdate());
	}

	#begin(text: string, indents: boolean): Editor {
		const root = this.querySelector(".pane-text")?.attachShadow({ mode: "open" });
		const options = {
			text,
			indents,
			label: "Grammar",
			help: KEYS,
			roles: this.source.roles ?? [],
			dialect: this.source.dialect,
		};
		return new Editor(root as ShadowRoot, options, {
			edited: (next, how) => this.#edited(next, how),
			settle: () => this.#settle(),
			undo: () => this.context.undo(),
			redo: () => this.context.redo(),
			leave: () => this.#leave(),
			at: (number, explained, production) => {
				this.number = number;
				this.explained = explained;
				this.production = production;
			},
			blurred: () => this.#settle(),
		});
	}

	#edited(text: string, how: string): void {
		const { context } = this;
		// Growth in progress is of an outdated text.
		if (context.state.growing) context.cancel();
		const run = how.startsWith("input.scrub") ? undefined : this.#runs.press(how);
		context.edit({ ...withText(this.source, context.state.specimen, text), run }, GESTURE);
		clearTimeout(this.#pause);
		if (run) this.#pause = setTimeout(this.#settle, PAUSE);
	}

	/** Escape first cancels a long growth, as in the whole page. */
	#leave(): void {
		if (this.context.state.growing) this.context.cancel();
		else this.querySelector<HTMLElement>("[data-close]")?.focus();
	}

	readonly #settle = (): void => {
		clearTimeout(this.#pause);
		this.context.settle(GESTURE);
	};

	readonly #step = (steps: number): void => this.#editor?.step(steps);

	readonly #grip = () => {
		this.#settle();
		return this.#editor?.grip();
	};

	readonly #drop = (): void => {
		this.context.set(withText(this.source, this.context.state.specimen, undefined));
		this.#editor?.focus();
	};

	readonly #setIndents = (event: Event): void => {
		const indents = (event.target as HTMLInputElement).checked;
		this.context.setToolState(this.tool, { ...this.context.toolState(this.tool), indents });
	};

	#hint(): unknown {
		const { explained } = this;
		if (!explained) return "Drag across a number to change it.";
		return html`<code>${explained.written}</code> ${explained.help}`;
	}

	#messages(problems: readonly Problem[]): unknown {
		const { fault, grown, grownFrom, specimen } = this.context.state;
		const current = grownFrom?.grammar === specimen.grammar && !fault;
		const warnings = grown && grownFrom && current ? (this.source.warnings?.(grown, grownFrom) ?? []) : [];
		const elsewhere = fault && fault.line === 0 ? html`<p class="error">${fault.message}</p>` : nothing;
		const list = problems.slice(0, MOST_MESSAGES).map(
			(problem) => html`<button type="button" class=${problem.severity} @click=${() => this.#editor?.goTo(problem)}>
				<b>Line ${problem.line}</b> ${problem.message}
			</button>`,
		);
		const more = problems.length - MOST_MESSAGES;
		const others =
			more > 0 ? html`<p class="remark">${more.toLocaleString("en-GB")} more are marked in the text.</p>` : nothing;
		return html`${elsewhere}${warnings.map((words) => html`<p class="remark">${words}</p>`)}${list}${others}`;
	}
}

customElements.define("panicle-grammar", GrammarPane);
