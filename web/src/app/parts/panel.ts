import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { allBut } from "../../specimen/all_but";
import { control } from "../../ui/control";
import { BASICS, type Tool } from "../../ui/tool";
import { text } from "../messages.generated";
import { ADVANCED, applying, groupsFor, type PanelGroup, runningBy } from "../panel_groups";
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
	/** Subjects of the tools' groups when the panel was last drawn. */
	#subjects: ReadonlyMap<Tool, unknown> = new Map();

	/** Returns the values whose change redraws the panel. */
	protected override shows(studio: Studio): readonly unknown[] {
		const { model, modelUi, tools, ui, specimen } = studio.state;
		const own = allBut(specimen, runningBy(modelUi?.tools));
		const applied = applying(modelUi?.tools, specimen);
		return [model, modelUi, tools, ui.groups, ui.symbols, ...own, ...applied, ...subjectsOf(applied, studio).values()];
	}

	/** Opens each group that has another subject than before. */
	protected override updated(): void {
		const { modelUi, specimen } = this.context.state;
		const before = this.#subjects;
		this.#subjects = subjectsOf(applying(modelUi?.tools, specimen), this.context);
		for (const [tool, subject] of this.#subjects)
			if (subject !== undefined && subject !== before.get(tool)) void this.#reveal(tool);
	}

	/** Opens a group under "Advanced" and scrolls to it. */
	async #reveal({ panel }: Tool): Promise<void> {
		const { group = "" } = panel ?? {};
		const key = typeof group === "string" ? group : group.key;
		this.context.setGroup(ADVANCED, true);
		this.context.setGroup(key, true);
		await this.updateComplete;
		await new Promise(requestAnimationFrame); // The tool's own elements have then been drawn.
		this.#scrollTo(this.querySelector(`[data-group="${CSS.escape(key)}"]`));
	}

	/** Scrolls the panel until a group is in sight; never scrolls an element that also holds the plant. */
	#scrollTo(group: Element | null): void {
		let scroller = group?.parentElement ?? null;
		while (scroller && !(scroller.scrollHeight > scroller.clientHeight && isScrollable(scroller)))
			scroller = scroller.parentElement;
		if (!group || !scroller || scroller.querySelector("panicle-stage")) return;
		const [box, view] = [group.getBoundingClientRect(), scroller.getBoundingClientRect()];
		if (box.top < view.top) scroller.scrollTop += box.top - view.top;
		else if (box.bottom > view.bottom) scroller.scrollTop += Math.min(box.bottom - view.bottom, box.top - view.top);
	}

	/** Renders the basics, the numbers and, under "Advanced", all other groups, as sections that can be closed. */
	protected override draw(studio: Studio): unknown {
		const { model, specimen, modelUi, ui } = studio.state;
		if (!modelUi) return nothing;
		const groups = groupsFor(model.table, specimen, applying(modelUi.tools, specimen));
		const sections = groups.map((group) => sectionOf(studio, group));
		const basics = sections.filter(({ key }) => key === BASICS);
		const others = sections.filter(({ key }) => key !== BASICS);
		const numbers = {
			key: "numbers",
			title: text("panel_numbers"),
			body: html`<panicle-readout .context=${studio}></panicle-readout>`,
		};
		const advanced = {
			key: ADVANCED,
			title: text("panel_advanced"),
			closed: true,
			body: html`${this.#symbolSwitch(studio)} ${this.#sections(studio, others)}`,
		};
		return html`<div class=${ui.symbols ? "panel-groups" : "panel-groups without-symbols"}>
				<h2 class="unseen">${text("page_controls")}</h2>
				${this.#sections(studio, [...basics, numbers, ...(others.length > 0 ? [advanced] : [])])}
			</div>`;
	}

	/** Renders the switch of the symbols, if the model has any. */
	#symbolSwitch(studio: Studio): unknown {
		const { model, ui } = studio.state;
		if (model.table.entries.every(({ symbol }) => symbol === "")) return nothing;
		return html`<label class="toggle">
			<input
				type="checkbox" role="switch" .checked=${ui.symbols}
				@change=${(event: Event) => studio.setUi({ symbols: (event.target as HTMLInputElement).checked })}
			>${text("panel_symbols")}
		</label>`;
	}

	#sections(studio: Studio, sections: readonly Section[]): unknown {
		return repeat(
			sections,
			({ key }) => `${studio.state.model.name} ${key}`,
			(section) => this.#section(studio, section),
		);
	}

	/**
	 * Renders a section.
	 * @param section.closed whether it is closed until the user opens it
	 */
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

	/**
	 * Opens or closes a group through the state; the element itself only does so for the browser's find in page
	 * (`toggle`).
	 */
	#flip(event: Event, key: string, open: boolean): void {
		event.preventDefault();
		this.context.setGroup(key, open);
	}
}

/** Returns whether the user can scroll an element up and down. */
const isScrollable = (element: Element): boolean => /auto|scroll/.test(getComputedStyle(element).overflowY);

/** Returns the subject of each tool's group that can have one. */
const subjectsOf = (tools: readonly Tool[], studio: Studio): ReadonlyMap<Tool, unknown> =>
	new Map(tools.flatMap((tool) => (tool.panel?.subject ? [[tool, tool.panel.subject(studio)]] : [])));

/** Returns the controls of one group, with those that tools add. */
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

customElements.define("panicle-panel", Panel);
