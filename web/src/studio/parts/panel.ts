import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { GROUPS, type GroupInfo, PARAMETERS, type ParameterInfo } from "../../specimen/parameters.generated";
import { isAsPrinted } from "../change";
import type { Studio } from "../studio";
import type { Locks } from "../types";
import { icon } from "./icons";
import { grammarOverride, inputsOverride } from "./overrides";
import { readout } from "./readout";
import { StudioElement } from "./studio_element";
import { symbol } from "./symbol";
import "./colour";
import "./number";

/** The controls in their groups, made from the parameter table; which groups are closed is remembered. */
export class Panel extends StudioElement {
	static override properties = { ...StudioElement.properties, explained: { state: true } };
	/** The parameter under the pointer or in focus. */
	declare private explained: ParameterInfo | undefined;

	protected override draw(studio: Studio): unknown {
		return html`<div class="panel-groups" @pointerover=${this.#explain} @focusin=${this.#explain}>
				${GROUPS.map((group) => this.#group(studio, group.key, group.title, this.#controls(studio, group)))}
				${this.#group(studio, "numbers", "Numbers", readout(studio.state))}
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

	#controls(studio: Studio, group: GroupInfo): unknown {
		const infos = PARAMETERS.filter((info) => info.group === group.key);
		return html`${group.key === "shape" ? nothing : html`<p>${group.help}</p>`}
			${group.key === "between" ? asPrintedSwitch(studio) : nothing}
			${group.key === "shape" ? inputsOverride(studio) : nothing}
			${group.key === "branching" ? grammarOverride(studio) : nothing}
			${repeat(
				infos,
				(info) => info.key,
				(info) => control(studio, info),
			)}
			${group.key === "shape" ? sideActions(studio) : nothing}`;
	}

	#explain(event: Event): void {
		const key = (event.target as Element).closest<HTMLElement>("[data-key]")?.dataset.key;
		const info = PARAMETERS.find((each) => each.key === key);
		if (info) this.explained = info;
	}
}

const FIRST_WORDS = "Drag a handle or a slider. Double-click a slider to bring its preset's value back.";

function explanation(info: ParameterInfo, studio: Studio): unknown {
	const { look, parameters } = studio.preset;
	const preset = { ...look, ...parameters }[info.key];
	const range = info.kind === "colour" ? "" : `${info.min} … ${info.max} ${info.unit}. `;
	return html`<strong>${info.label}</strong> ${symbol(info.symbol)}:
		${info.help} ${range}Double-click for ${preset}.`;
}

function control(studio: Studio, info: ParameterInfo): unknown {
	return info.kind === "colour"
		? html`<panicle-colour .studio=${studio} .info=${info}></panicle-colour>`
		: html`<panicle-number .studio=${studio} .info=${info}></panicle-number>`;
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
