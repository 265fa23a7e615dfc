import { html, nothing } from "lit";
import type { TextPlace } from "../plant/derivation_trace";
import { ControlElement } from "../ui/control_element";
import { Derivation } from "./derivation";
import { DERIVATION } from "./derivation_tool";
import type { StringEvents } from "./derived_string";
import type { GrammarContext } from "./source";
import STYLE from "./steps.css?inline";
import {
	answerInWords,
	chanceInWords,
	countInWords,
	fateOf,
	moduleInWords,
	piecesOf,
	stepInWords,
	valuesInWords,
} from "./trace_words";
import "./derived_string";
import "./step_bar";
import { text } from "./messages.generated";

/** Duration of a step during playback, milliseconds; longer with reduced motion. */
const STAND = 1100;
const STAND_STILL = 2200;

/** Productions of the chosen module in the text. */
export interface ShownProductions {
	/** Production that rewrites the module next. */
	readonly fires?: TextPlace | undefined;
	/** Production that wrote the module. */
	readonly wrote?: TextPlace | undefined;
}

/**
 * Step viewer of a derivation: the string of each step, and for a module its productions, values, queries and
 * responses.
 */
export class Stepper extends ControlElement<GrammarContext> {
	static override properties = {
		...ControlElement.properties,
		line: { attribute: false },
		shown: { attribute: false },
		goTo: { attribute: false },
	};
	/** Line of the production at the text's cursor. */
	declare line: number | undefined;
	/** Called with the productions to mark in the text. */
	declare shown: (productions: ShownProductions) => void;
	/** Moves the cursor to a place of the text. */
	declare goTo: (place: TextPlace) => void;

	#derivation: Derivation | undefined;
	#playing: ReturnType<typeof setTimeout> | undefined;
	#shownPlaces: readonly unknown[] = [];

	/** Adds the style sheet. */
	override connectedCallback(): void {
		super.connectedCallback();
		addStyle();
	}

	/** Stops playback, and shows the document's plant again. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#stop();
		this.#derivation?.close();
		this.#derivation = undefined;
		this.shown({});
	}

	/** Returns the values whose change redraws the stepper. */
	protected override shows({ state }: GrammarContext): readonly unknown[] {
		const { met, follows, scene } = this.context.toolState(DERIVATION);
		return [state.grown, state.grownFrom, met, follows, scene];
	}

	/** Renders the steps, a window of the derived string, and the chosen module's explanation. */
	protected override draw(): unknown {
		if (!this.isConnected) return nothing;
		this.#derivation ??= new Derivation(this.context, () => this.requestUpdate());
		const derivation = this.#derivation;
		const { counts, step, page, fault } = derivation;
		const none = html`<p class="steps-none" role="status">${fault ? text("steps_failed", { problem: fault }) : text("deriving")}</p>`;
		if (!counts || step === undefined) return none;
		const last = counts.length - 1;
		const bar = html`<panicle-steps
				.counts=${counts} .step=${step} .playing=${this.#playing !== undefined} .play=${this.#togglePlayback} .go=${this.#goTo} .by=${this.#stepBy}
				.follows=${derivation.follows} .follow=${this.#toggleFollows}
			></panicle-steps>`;
		// Another step may still work.
		if (fault) return html`${bar}${none}`;
		const label = text("string", { step: stepInWords(step, last), count: countInWords(counts[step]) });
		return html`<p class="unseen" id="derived-keys">${text("string_keys")}</p>
			${bar}
			<panicle-derived
				.page=${page} .busy=${!page || derivation.stale} .chosen=${derivation.chosen} .pointed=${derivation.pointed} .line=${this.line} .label=${label}
				.events=${this.#events}
			></panicle-derived>
			${this.#placeSlider(derivation, counts[step])}
			<div class="trace-card">${this.#card(derivation, last)}</div>
			<p class="unseen" role="status">${this.#announcement(derivation, last)}</p>`;
	}

	/**
	 * Reports the places in the text of the productions that concern the pointed or chosen module, if they changed; stops
	 * playing at the last step or on an error.
	 */
	protected override updated(): void {
		const derivation = this.#derivation;
		if (!derivation) return;
		derivation.follow();
		const { fires, production } = derivation.module(derivation.pointed ?? derivation.chosen) ?? {};
		const places = derivation.stale ? [] : [fires?.line, fires?.column, production?.line, production?.column];
		if (places.length !== this.#shownPlaces.length || places.some((each, index) => each !== this.#shownPlaces[index])) {
			this.#shownPlaces = places;
			this.shown(derivation.stale ? {} : { fires, wrote: production });
		}
		if (this.#playing !== undefined && (derivation.fault || derivation.step === derivation.last)) this.#stop();
	}

	/** Draws a slider for the window's place in a string that is longer than the window. */
	#placeSlider({ page, chosen }: Derivation, length: number): unknown {
		if (!page || length <= page.modules.length) return nothing;
		const at = chosen ?? page.first;
		return html`<label class="string-place">
			<span>${text("window", { first: page.first + 1, last: page.first + page.modules.length })}</span>
			<input
				type="range" min="0" max=${length - 1} step="1" .value=${String(at)} .style=${`--done: ${(100 * at) / (length - 1)}%`}
				aria-label=${text("place")} aria-valuetext=${text("module_of", { number: at + 1, count: length })}
				@input=${(event: Event) => this.#derivation?.choose(Number((event.target as HTMLInputElement).value))}
			>
		</label>`;
	}

	/** Draws the description of the chosen module; advice without one. */
	#card(derivation: Derivation, last: number): unknown {
		const { chosen, step, counts } = derivation;
		const module = derivation.module(chosen);
		if (!module || chosen === undefined || step === undefined || !counts) {
			const marked = this.line === undefined ? "" : this.#describeProduction(derivation, this.line);
			const hint = marked || text("choose_module");
			return html`<p class="trace-hint">${hint} ${this.#next(derivation)}</p>`;
		}
		const { production, fires, answer, chance, parent, children, refusals } = module;
		const line = ({ line, column }: TextPlace) =>
			html`<button class="to-line" type="button" @click=${() => this.goTo({ line, column })}>${text("line", { line: String(line) })}</button>`;
		const walk = (label: string, arrow: string, press: () => void, off: boolean) =>
			html`<button class="button quiet" type="button" aria-disabled=${off} @click=${() => off || press()}>${arrow} ${label}</button>`;
		const values = valuesInWords(module);
		const when = step === last ? "drawn" : "next";
		const rewritten = !fires
			? nothing
			: values
				? text.pieces("rewritten_with", { when, line: line(fires), values: html`<code>${values}</code>` })
				: text.pieces("rewritten", { when, line: line(fires) });
		return html`<header>
				<code title=${module.text}>${module.text}</code>
				<span>${text("number_of", { number: chosen + 1, count: counts[step] })}</span>
				${walk(text("parent"), "↑", () => derivation.up(), parent === undefined || step === 0)}
				${walk(text("children"), "↓", () => derivation.down(), step === last || children.count === 0)}
			</header>
			${
				answer
					? html`<p class="trace-answer">${answerInWords(answer)} ${this.#next(derivation)}${this.#reasons(answer.words)}</p>`
					: nothing
			}
			${production ? html`<p>${text.pieces("written_by", { line: line(production) })}</p>` : nothing}
			<p>${rewritten} ${fires && chance ? chanceInWords(chance) : nothing}
				${fateOf(module, step === last)} ${derivation.bare ? text("draws_nothing") : nothing}</p>
			${
				refusals
					? html`<ul class="trace-refusals" aria-label=${text("refusals")}>${refusals.map(
							({ production, why }) =>
								html`<li>${text.pieces("refused", { line: line(production), reason: why })}</li>`,
						)}</ul>`
					: nothing
			}`;
	}

	/**
	 * Draws the environment's reasons for its response. Indices of modules in them become buttons, numbered from 1 as
	 * everywhere in the page, that choose the module.
	 */
	#reasons(words: string | undefined): unknown {
		if (!words) return nothing;
		return html`<b>${piecesOf(words).map((piece) =>
			typeof piece === "string" ? piece : this.#moduleButton(piece),
		)}</b>`;
	}

	/** Draws a button that chooses the module of an index; its label counts from 1. */
	#moduleButton(index: number): unknown {
		return html`<button class="to-line" type="button" @click=${() => this.#derivation?.choose(index)}>${index + 1}</button>`;
	}

	/** Draws a button that moves to the next module with a query, cyclically. */
	#next({ page, chosen = -1 }: Derivation): unknown {
		const asked = page?.modules.flatMap(({ answer }, index) => (answer ? [page.first + index] : [])) ?? [];
		const next = asked.find((index) => index > chosen) ?? asked[0];
		if (next === undefined || next === chosen) return nothing;
		const press = () => this.#derivation?.choose(next);
		return html`<button class="to-line" type="button" @click=${press}>${text("next_query")}</button>`;
	}

	/**
	 * Describes how often the production at the text's cursor applies in the loaded window.
	 * @param line line of that production
	 */
	#describeProduction({ page }: Derivation, line: number): string {
		if (!page) return "";
		const fires = page.modules.filter((each) => each.fires?.line === line).length;
		const wrote = page.modules.filter((each) => each.production?.line === line).length;
		if (fires + wrote === 0) return text("applies_nowhere", { line: String(line) });
		const whole = page.modules.length === page.counts[page.step];
		return text(whole ? "applies" : "applies_here", { line: String(line), wrote, fires });
	}

	/** Returns the words that screen readers announce: the chosen module, or the step, which is silent while playing. */
	#announcement(derivation: Derivation, last: number): string {
		const { page, chosen, step, counts } = derivation;
		if (!page || step === undefined || !counts) return "";
		const module = derivation.module(chosen);
		const words = { step: stepInWords(step, last), count: countInWords(counts[step]) };
		if (!module) return this.#playing === undefined ? text("step_and_count", words) : "";
		return text("announced", {
			step: words.step,
			module: module.text,
			words: moduleInWords(module, step === last),
		});
	}

	readonly #events: StringEvents = {
		choose: (index) => this.#derivation?.choose(index),
		point: (index) => this.#derivation?.point(index),
		look: (about) => this.#derivation?.look(about),
		up: () => void this.#derivation?.up(),
		down: () => void this.#derivation?.down(),
		open: () => {
			const { fires, production } = this.#derivation?.module(this.#derivation.chosen) ?? {};
			const place = fires ?? production;
			if (place) this.goTo(place);
		},
	};

	/** Stops playback and goes to a step. */
	readonly #goTo = (step: number): void => {
		this.#stop();
		this.#derivation?.go(step);
	};

	/** Stops playback and moves one step, with the chosen module. */
	readonly #stepBy = (by: 1 | -1): void => {
		this.#stop();
		this.#derivation?.stepBy(by);
	};

	/** Toggles whether the view shows the plant of the step. */
	readonly #toggleFollows = (): void => {
		const derivation = this.#derivation;
		if (derivation) derivation.follows = !derivation.follows;
	};

	/** Starts playback, from the axiom if the last step is shown, or stops it. */
	readonly #togglePlayback = (): void => {
		if (this.#playing !== undefined) {
			this.#stop();
			return;
		}
		const derivation = this.#derivation;
		if (derivation?.step === derivation?.last) derivation?.go(0);
		this.#playOn();
	};

	/** Schedules the next step of the playback; a step whose string is still loading is repeated. */
	readonly #playOn = (): void => {
		const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
		this.#playing = setTimeout(
			() => {
				if (this.#derivation?.page) this.#derivation.stepBy(1);
				this.#playOn();
			},
			still ? STAND_STILL : STAND,
		);
		this.requestUpdate();
	};

	/** Stops playback. */
	#stop(): void {
		clearTimeout(this.#playing);
		this.#playing = undefined;
		this.requestUpdate();
	}
}

let isStyled = false;

/**
 * Adds the style sheet as a constructed sheet, which the content security policy allows; the sheet is not part of the
 * first load.
 */
function addStyle(): void {
	if (isStyled) return;
	isStyled = true;
	const sheet = new CSSStyleSheet();
	sheet.replaceSync(STYLE);
	document.adoptedStyleSheets.push(sheet);
}

customElements.define("panicle-stepper", Stepper);
