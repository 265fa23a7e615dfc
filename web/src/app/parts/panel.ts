import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { allBut } from "../../specimen/all_but";
import { control } from "../../ui/control";
import { symbol } from "../../ui/symbol";
import { type Explained, explainedAt, explainedBy, FIRST_WORDS, presetInWords } from "../explained";
import { applying, groupsFor, type PanelGroup, runningBy } from "../panel_groups";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "./readout";

/** A group of the panel, ready to be drawn. */
interface Section {
	readonly key: string;
	readonly title: string;
	readonly closed?: boolean;
	readonly body: unknown;
}

/** The controls in their groups, from the model's table; the page remembers which groups are closed. */
export class Panel extends StudioPart {
	/** The explanation of the control under the pointer or in focus. */
	#explained: Explained | undefined;

	protected override shows({ state: { model, modelUi, tools, ui, specimen } }: Studio): readonly unknown[] {
		const own = allBut(specimen, runningBy(modelUi?.tools));
		return [model, modelUi, tools, ui.groups, ...own, ...applying(modelUi?.tools, specimen)];
	}

	protected override draw(studio: Studio): unknown {
		const { model, specimen, modelUi } = studio.state;
		if (!modelUi) return nothing;
		const groups = groupsFor(model.table, specimen, applying(modelUi.tools, specimen));
		const everyday = groups.filter(({ group }) => group.everyday).map((group) => sectionOf(studio, group));
		const constants = groups.filter(({ group }) => !group.everyday).map((group) => sectionOf(studio, group));
		// The numbers come between the everyday groups and the rest.
		const numbers = {
			key: "numbers",
			title: "Numbers",
			body: html`<panicle-readout .context=${studio}></panicle-readout>`,
		};
		return html`<div class="panel-groups" @pointerover=${this.#explain} @focusin=${this.#explain}>
				${repeat(
					[...everyday, numbers, ...constants],
					({ key }) => `${model.name} ${key}`,
					(section) => this.#section(studio, section),
				)}
			</div>
			<p class="explain" aria-hidden="true">${this.#explained ? explanation(this.#explained, studio) : FIRST_WORDS}</p>`;
	}

	#section(studio: Studio, { key, title, closed = false, body }: Section): unknown {
		const open = studio.state.ui.groups[key] ?? !closed;
		const toggled = (event: Event) => {
			const shown = (event.target as HTMLDetailsElement).open;
			if (shown !== (studio.state.ui.groups[key] ?? !closed)) studio.setGroup(key, shown);
		};
		return html`<details class="group" data-group=${key} .open=${open} @toggle=${toggled}>
			<summary @click=${(event: Event) => this.#flip(event, key, !open)}>${title}</summary>
			<div class="group-body">${body}</div>
		</details>`;
	}

	/** Opens or closes a group through the state; the element itself only does so for the browser's find in page (`toggle`). */
	#flip(event: Event, key: string, open: boolean): void {
		event.preventDefault();
		this.context.setGroup(key, open);
	}

	#explain(event: Event): void {
		const place = event.target as Element;
		const key = place.closest<HTMLElement>("[data-key]")?.dataset.key;
		const { model, specimen } = this.context.state;
		const found = key === undefined ? explainedAt(place) : explainedBy(model, specimen, key);
		if (!found || found.key === this.#explained?.key) return;
		this.#explained = found;
		this.requestUpdate();
	}
}

/** The controls of one group, with what the tools add. */
function sectionOf(studio: Studio, { group, entries, above, below }: PanelGroup): Section {
	const { key, title, closed, help, plain } = group;
	const tool = ({ panel }: (typeof above)[number]) => panel?.draw(studio);
	const body = html`${plain ? nothing : html`<p>${help}</p>`} ${above.map(tool)}
		${repeat(
			entries,
			(entry) => entry.key,
			(entry) => control(studio, entry),
		)}
		${below.map(tool)}`;
	return { key, title, closed, body };
}

function explanation({ key, label, symbol: sign, text }: Explained, { state, preset }: Studio): unknown {
	const published = presetInWords(state.model, preset, key);
	return html`<strong>${label}</strong>${symbol(sign)}: ${text} ${published === undefined ? nothing : `Double-click for ${published}.`}`;
}

customElements.define("panicle-panel", Panel);
