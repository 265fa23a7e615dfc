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

/** Duration of a step during playback, milliseconds; longer with reduced motion. */
const STAND = 1100;
const STAND_STILL = 2200;

const KEYS =
	"Left and right go from module to module, Up to the one it came from in the step before, Down to what it becomes in the next, Home and End to the ends. Enter leads to its production in the grammar.";

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

	override connectedCallback(): void {
		super.connectedCallback();
		dress();
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#stop();
		this.#derivation?.close();
		this.#derivation = undefined;
		this.shown({});
	}

	protected override shows({ state }: GrammarContext): readonly unknown[] {
		const { met, follows, scene } = this.context.toolState(DERIVATION);
		return [state.grown, state.grownFrom, met, follows, scene];
	}

	protected override draw(): unknown {
		if (!this.isConnected) return nothing;
		this.#derivation ??= new Derivation(this.context, () => this.requestUpdate());
		const derivation = this.#derivation;
		const { counts, step, page, fault } = derivation;
		const none = html`<p class="steps-none" role="status">${fault ? `The steps cannot be told: ${fault}` : "Deriving …"}</p>`;
		if (!counts || step === undefined) return none;
		const last = counts.length - 1;
		const bar = html`<panicle-steps
				.counts=${counts} .step=${step} .playing=${this.#playing !== undefined} .play=${this.#toggle} .go=${this.#go} .by=${this.#by}
				.follows=${derivation.follows} .follow=${this.#follow}
			></panicle-steps>`;
		// Another step may still work.
		if (fault) return html`${bar}${none}`;
		const label = `String: ${stepInWords(step, last)}, ${countInWords(counts[step])}`;
		return html`<p class="unseen" id="derived-keys">${KEYS}</p>
			${bar}
			<panicle-derived
				.page=${page} .busy=${!page || derivation.stale} .chosen=${derivation.chosen} .pointed=${derivation.pointed} .line=${this.line} .label=${label}
				.events=${this.#events}
			></panicle-derived>
			${this.#place(derivation, counts[step])}
			<div class="trace-card">${this.#card(derivation, last)}</div>
			<p class="unseen" role="status">${this.#announcement(derivation, last)}</p>`;
	}

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

	/** Draws a slider for the window's place in a longer string. */
	#place({ page, chosen }: Derivation, length: number): unknown {
		if (!page || length <= page.modules.length) return nothing;
		const at = chosen ?? page.first;
		return html`<label class="string-place">
			<span>${(page.first + 1).toLocaleString("en-GB")} – ${(page.first + page.modules.length).toLocaleString("en-GB")}</span>
			<input
				type="range" min="0" max=${length - 1} step="1" .value=${String(at)} .style=${`--done: ${(100 * at) / (length - 1)}%`}
				aria-label="Place in the string" aria-valuetext="module ${(at + 1).toLocaleString("en-GB")} of ${length.toLocaleString("en-GB")}"
				@input=${(event: Event) => this.#derivation?.choose(Number((event.target as HTMLInputElement).value))}
			>
		</label>`;
	}

	/** Describes the chosen module. */
	#card(derivation: Derivation, last: number): unknown {
		const { chosen, step, counts } = derivation;
		const module = derivation.module(chosen);
		if (!module || chosen === undefined || step === undefined || !counts) {
			const words = this.line === undefined ? "" : this.#marked(derivation, this.line);
			const hint = words || "Choose a module, here or in the view: its production, its values, where it came from.";
			return html`<p class="trace-hint">${hint} ${this.#next(derivation)}</p>`;
		}
		const { production, fires, answer, chance, parent, children, refusals } = module;
		const line = ({ line, column }: TextPlace) =>
			html`<button class="to-line" type="button" @click=${() => this.goTo({ line, column })}>line ${line}</button>`;
		const walk = (words: string, arrow: string, press: () => void, off: boolean) =>
			html`<button class="button quiet" type="button" aria-disabled=${off} @click=${() => off || press()}>${arrow} ${words}</button>`;
		const values = valuesInWords(module);
		return html`<header>
				<code title=${module.text}>${module.text}</code>
				<span>${(chosen + 1).toLocaleString("en-GB")} of ${counts[step].toLocaleString("en-GB")}</span>
				${walk("Parent", "↑", () => derivation.up(), parent === undefined || step === 0)}
				${walk("Children", "↓", () => derivation.down(), step === last || children.count === 0)}
			</header>
			${
				answer
					? html`<p class="trace-answer">${answerInWords(answer)}. ${this.#next(derivation)}${this.#why(answer.words)}</p>`
					: nothing
			}
			${production ? html`<p>Written by ${line(production)}.</p>` : nothing}
			<p>${fires ? html`Rewritten ${step === last ? "where it is drawn" : "next"} by ${line(fires)}${values ? html` with <code>${values}</code>` : nothing}${chance ? html`, ${chanceInWords(chance)}` : nothing}. ` : nothing}
				${fateOf(module, step === last)}${derivation.bare ? " It draws nothing." : nothing}</p>
			${
				refusals
					? html`<ul class="trace-refusals" aria-label="Productions that do not apply">${refusals.map(
							({ production, why }) => html`<li>Not ${line(production)}: ${why}.</li>`,
						)}</ul>`
					: nothing
			}`;
	}

	/** Draws the environment's words; modules named in them are buttons. */
	#why(words: string | undefined): unknown {
		if (!words) return nothing;
		return html`<b>${piecesOf(words).map((piece) =>
			typeof piece === "string"
				? piece
				: html`<button class="to-line" type="button" @click=${() => this.#derivation?.choose(piece)}>module ${piece + 1}</button>`,
		)}.</b>`;
	}

	/** Draws a button that moves to the next module with a query, cyclically. */
	#next({ page, chosen = -1 }: Derivation): unknown {
		const asked = page?.modules.flatMap(({ answer }, index) => (answer ? [page.first + index] : [])) ?? [];
		const next = asked.find((index) => index > chosen) ?? asked[0];
		if (next === undefined || next === chosen) return nothing;
		const press = () => this.#derivation?.choose(next);
		return html`<button class="to-line" type="button" @click=${press}>Next question</button>`;
	}

	/** Describes the production at the text's cursor. */
	#marked({ page }: Derivation, line: number): string {
		if (!page) return "";
		const fires = page.modules.filter((each) => each.fires?.line === line).length;
		const wrote = page.modules.filter((each) => each.production?.line === line).length;
		if (fires + wrote === 0) return `The production in line ${line} has to do with no module here.`;
		const whole = page.modules.length === page.counts[page.step];
		return `The production in line ${line} wrote ${wrote} ${whole ? "of them" : "of those here"} and rewrites ${fires} next.`;
	}

	#announcement(derivation: Derivation, last: number): string {
		const { page, chosen, step, counts } = derivation;
		if (!page || step === undefined || !counts) return "";
		const module = derivation.module(chosen);
		if (!module) return this.#playing === undefined ? `${stepInWords(step, last)}, ${countInWords(counts[step])}` : "";
		return `${stepInWords(step, last)}: ${module.text}. ${moduleInWords(module, step === last)}`;
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

	readonly #go = (step: number): void => {
		this.#stop();
		this.#derivation?.go(step);
	};

	readonly #by = (by: 1 | -1): void => {
		this.#stop();
		this.#derivation?.stepBy(by);
	};

	readonly #follow = (): void => {
		const derivation = this.#derivation;
		if (derivation) derivation.follows = !derivation.follows;
	};

	readonly #toggle = (): void => {
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

	#stop(): void {
		clearTimeout(this.#playing);
		this.#playing = undefined;
		this.requestUpdate();
	}
}

let dressed = false;

/**
 * Adds the style sheet as a constructed sheet, which the content security policy allows; the sheet is not part of the
 * first load.
 */
function dress(): void {
	if (dressed) return;
	dressed = true;
	const sheet = new CSSStyleSheet();
	sheet.replaceSync(STYLE);
	document.adoptedStyleSheets.push(sheet);
}

customElements.define("panicle-stepper", Stepper);
