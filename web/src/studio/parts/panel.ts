import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { Procedure } from "../../models/bunch/grown";
import type { ParameterInfo } from "../../models/bunch/parameters.generated";
import { isAsPrinted } from "../change";
import { type Explained, explainedBy, FIRST_WORDS, presetInWords } from "../explained";
import { groupsFor, type PanelGroup, procedureOf } from "../panel_groups";
import type { Studio } from "../studio";
import type { Locks } from "../types";
import { icon } from "./icons";
import { grammarOverride, inputsOverride } from "./overrides";
import { readout } from "./readout";
import { StudioElement } from "./studio_element";
import { symbol } from "./symbol";
import "./choice";
import "./colour";
import "./number";
import "./thinning";

/** The controls in their groups, made from the parameter table; which groups are closed is remembered. */
export class Panel extends StudioElement {
	static override properties = { ...StudioElement.properties, explained: { state: true } };
	/** What is under the pointer or in focus. */
	declare private explained: Explained | undefined;

	protected override draw(studio: Studio): unknown {
		const procedure = procedureOf(studio.state.specimen);
		const parts = groupsFor(procedure).map((each) => ({
			key: each.group.key,
			title: each.group.title,
			body: controls(studio, each, procedure),
		}));
		const everyday = parts.filter(({ key }) => EVERYDAY.includes(key));
		const constants = parts.filter(({ key }) => !EVERYDAY.includes(key));
		const numbers = { key: "numbers", title: "Numbers", body: readout(studio.state) };
		return html`<div class="panel-groups" @pointerover=${this.#explain} @focusin=${this.#explain}>
				${repeat(
					[...everyday, numbers, ...constants],
					({ key }) => key,
					({ key, title, body }) => this.#group(studio, key, title, body),
				)}
			</div>
			<p class="explain" aria-hidden="true">${this.explained ? explanation(this.explained, studio) : FIRST_WORDS}</p>`;
	}

	#group(studio: Studio, key: string, title: string, body: unknown): unknown {
		const open = !studio.state.ui.closed.includes(key);
		const toggled = (event: Event) => studio.setGroup(key, (event.target as HTMLDetailsElement).open);
		return html`<details class="group" data-group=${key} .open=${open} @toggle=${toggled}>
			<summary @click=${(event: Event) => this.#flip(event, key, !open)}>${title}</summary>
			<div class="group-body">${body}</div>
		</details>`;
	}

	/** The state opens and closes, not the element of itself; a search in the page still may (`toggle`). */
	#flip(event: Event, key: string, open: boolean): void {
		event.preventDefault();
		this.studio.setGroup(key, open);
	}

	#explain(event: Event): void {
		const key = (event.target as Element).closest<HTMLElement>("[data-key]")?.dataset.key;
		this.explained = (key === undefined ? undefined : explainedBy(key)) ?? this.explained;
	}
}

/** What most people touch; the numbers stand between these and the grammar's constants. */
const EVERYDAY: readonly string[] = ["shape", "berries", "age", "wing", "look"];

/** The controls of one group, with what else belongs there. */
function controls(studio: Studio, { group, infos }: PanelGroup, procedure: Procedure): unknown {
	const { key } = group;
	return html`${key === "shape" ? inputsOverride(studio) : html`<p>${group.help}</p>`}
		${key === "between" && procedure === "paper" ? asPrintedSwitch(studio) : nothing}
		${key === "branching" ? grammarOverride(studio) : nothing}
		${repeat(
			infos,
			(info) => info.key,
			(info) => control(studio, info),
		)}
		${key === "shape" ? sideActions(studio) : nothing}
		${key === "berries" && procedure === "natural" ? html`<panicle-thinning .studio=${studio}></panicle-thinning>` : nothing}`;
}

function explanation({ key, label, symbol: sign, text }: Explained, studio: Studio): unknown {
	const preset = presetInWords(studio.preset, key);
	return html`<strong>${label}</strong>${symbol(sign)}: ${text} ${preset === undefined ? nothing : `Double-click for ${preset}.`}`;
}

function control(studio: Studio, info: ParameterInfo): unknown {
	if (info.kind === "colour") return html`<panicle-colour .studio=${studio} .info=${info}></panicle-colour>`;
	if (info.kind === "choice") return html`<panicle-choice .studio=${studio} .info=${info}></panicle-choice>`;
	return html`<panicle-number .studio=${studio} .info=${info}></panicle-number>`;
}

function asPrintedSwitch(studio: Studio): unknown {
	const changed = (event: Event) => studio.setAsPrinted((event.target as HTMLInputElement).checked);
	return html`<label class="toggle">
		<input type="checkbox" role="switch" .checked=${isAsPrinted(studio.state.specimen)} @change=${changed}>As printed
	</label>`;
}

function sideActions(studio: Studio): unknown {
	const lock = (which: keyof Locks, words: string) =>
		html`<button class="button" type="button" aria-pressed=${studio.state.ui.locks[which]} @click=${() => studio.toggleLock(which)}>
			${words}
		</button>`;
	const mirror = (which: keyof Locks, words: string) =>
		html`<button class="button" type="button" @click=${() => studio.mirror(which)}>${icon("mirror")}${words}</button>`;
	return html`<div class="actions">
		${lock("leftRight", "Lock left–right")} ${lock("frontBack", "Lock front–back")}
		${mirror("leftRight", "Mirror left–right")} ${mirror("frontBack", "Mirror front–back")}
	</div>`;
}

customElements.define("panicle-panel", Panel);
