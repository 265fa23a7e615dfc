import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { rangeInWords } from "../../specimen/lengths";
import { icon } from "../../ui/icons";
import { typedName } from "../../ui/typed";
import {
	acceptedText,
	type BatchRow,
	type BatchSetting,
	constantsOf,
	optionLabel,
	readRow,
	rowFor,
	type SettingGroup,
	settingGroups,
	VARIATIONS,
	type Variation,
	withVariation,
} from "../files/batch_rows";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "../style/batch.css";

/** A row of the form. */
interface FormRow extends BatchRow {
	/** Stays the same while the row's setting changes. */
	readonly id: number;
	readonly problem?: { readonly text: string; readonly at: number };
}

type NumberSetting = Extract<BatchSetting, { kind: "number" }>;

const VARIATION_TEXTS: Readonly<Record<Variation, () => string>> = {
	range: () => text("batch_range"),
	list: () => text("batch_list"),
	fixed: () => text("batch_fixed"),
};

/** The settings that vary in a batch: a row for each, with the setting, the kind of variation and the values. */
export class BatchRows extends StudioPart {
	#rows: readonly FormRow[] = [];
	#groups: readonly SettingGroup[] = [];
	#made = 0;

	/** Returns the values whose change redraws the rows. */
	protected override shows({ state: { model } }: Studio): readonly unknown[] {
		return [model];
	}

	/** Renders the rows and the button that adds one. */
	protected override draw(): unknown {
		const isFull = this.#rows.length >= this.#settings().length;
		return html`<fieldset class="vary" aria-describedby=${this.idOf("about")}>
			<legend>${text("batch_vary")}</legend>
			<p id=${this.idOf("about")}>${text("batch_vary_about")}</p>
			${repeat(
				this.#rows,
				({ id }) => id,
				(row) => this.#row(row),
			)}
			<button class="button" type="button" data-add ?disabled=${isFull} @click=${this.#add}>${text("batch_add")}</button>
		</fieldset>`;
	}

	/** Prepares the rows for the plant on the controls; rows of settings that it does not have are removed. */
	async refresh(): Promise<void> {
		const { state } = this.context;
		this.#groups = settingGroups(state, await constantsOf(state));
		this.#rows = this.#rows.filter(({ key }) => this.#setting(key));
		this.requestUpdate();
	}

	/**
	 * Returns the rows in the syntax of `--vary`; undefined if a row has a problem, which it then shows; the focus moves
	 * to the first field with one.
	 */
	async read(): Promise<string | undefined> {
		const written: string[] = [];
		this.#rows = this.#rows.map(({ problem: _, ...row }) => {
			const setting = this.#setting(row.key);
			if (!setting) return row;
			const read = readRow(setting, row);
			if ("vary" in read) written.push(read.vary);
			return "vary" in read ? row : { ...row, problem: { text: read.problem, at: read.at } };
		});
		this.requestUpdate();
		await this.updateComplete;
		const wrong = this.querySelector<HTMLElement>("[aria-invalid=true]");
		wrong?.focus();
		return wrong ? undefined : written.join(",");
	}

	/** Returns all settings that can vary. */
	#settings(): readonly BatchSetting[] {
		return this.#groups.flatMap(({ settings }) => settings);
	}

	/** Returns the setting of a key; undefined where the plant does not have it. */
	#setting(key: string): BatchSetting | undefined {
		return this.#settings().find((each) => each.key === key);
	}

	/** Returns whether a row has the setting of a key. */
	#isUsed(key: string): boolean {
		return this.#rows.some((row) => row.key === key);
	}

	/** Renders a row: its setting, the fields of its values, and the button that removes it. */
	#row(row: FormRow): unknown {
		const setting = this.#setting(row.key);
		if (!setting) return nothing;
		const { label } = setting;
		const { problem } = row;
		const remove = text("batch_remove", { setting: label });
		return html`<div class="vary-row" role="group" aria-label=${label} data-key=${row.key}>
			${this.#chooser(row)}
			${setting.kind === "number" ? this.#number(setting, row) : nothing}
			${setting.kind === "choice" ? this.#choices(setting, row) : nothing}
			${setting.kind === "colour" ? this.#colours(setting, row) : nothing}
			<button class="button quiet icon" type="button" aria-label=${remove} title=${remove} @click=${() => this.#remove(row)}>${icon("close")}</button>
			<small class="problem" role="alert" id=${this.idOf(`problem-${row.id}`)}>${problem?.text ?? nothing}</small>
		</div>`;
	}

	/** Renders the list of settings, by the groups of the panel; settings of other rows cannot be chosen. */
	#chooser(row: FormRow): unknown {
		return html`<select aria-label=${text("batch_setting")} .value=${live(row.key)} @change=${({ target }: Event) => this.#choose(row, (target as HTMLSelectElement).value)}>
			${this.#groups.map(
				({ title, settings }) =>
					html`<optgroup label=${title}>${settings.map(
						({ key, label }) =>
							html`<option value=${key} ?selected=${key === row.key} ?disabled=${key !== row.key && this.#isUsed(key)}>${label}</option>`,
					)}</optgroup>`,
			)}
		</select>`;
	}

	/** Renders the kind of variation and the fields of a number. */
	#number(setting: NumberSetting, row: FormRow): unknown {
		const { entry, scale, label } = setting;
		const { variation } = row;
		const { unit } = scale;
		const named = typedName(label, unit);
		const field = (at: number, name: string) => this.#field(setting, row, at, name);
		const fields = {
			range: () =>
				text.pieces("batch_range_fields", {
					from: field(0, text("batch_from", { field: named })),
					to: field(1, text("batch_to", { field: named })),
					unit,
				}),
			list: () => html`${field(0, named)} ${unit}`,
			fixed: () => html`${field(0, named)} ${unit}`,
		};
		const hint = variation === "list" ? text("batch_list_help") : "";
		return html`<select
				aria-label=${text("batch_variation")} .value=${live(variation)}
				@change=${({ target }: Event) => this.#set({ ...row, ...withVariation(row, (target as HTMLSelectElement).value as Variation) })}
			>${VARIATIONS.map((each) => html`<option value=${each} ?selected=${each === variation}>${VARIATION_TEXTS[each]()}</option>`)}</select>
			<span class="values">${fields[variation]()}</span>
			<small id=${this.idOf(`hint-${row.id}`)}>${hint} ${entry ? rangeInWords(entry, scale) : nothing}</small>`;
	}

	/**
	 * Renders a field for a number.
	 * @param at index of the value in the row
	 * @param name the field's label for screen readers
	 */
	#field(setting: NumberSetting, row: FormRow, at: number, name: string): unknown {
		const { problem, id } = row;
		const set = ({ target }: Event) => {
			const typed = acceptedText(setting, row, (target as HTMLInputElement).value);
			this.#set({ ...row, values: row.values.map((value, each) => (each === at ? typed : value)) });
		};
		return html`<input
			type="text" inputmode=${row.variation === "list" ? "text" : "decimal"} autocomplete="off" spellcheck="false" aria-label=${name}
			aria-describedby=${`${this.idOf(`problem-${id}`)} ${this.idOf(`hint-${id}`)}`} aria-invalid=${problem?.at === at ? "true" : nothing}
			data-list=${row.variation === "list" ? "" : nothing} .value=${live(row.values[at])} @change=${set}
		>`;
	}

	/** Renders a checkbox for each option. */
	#choices({ entry }: Extract<BatchSetting, { kind: "choice" }>, row: FormRow): unknown {
		const { values, problem } = row;
		const toggle = (option: string) => {
			const chosen = entry.options.filter((each) => (each === option) !== values.includes(each));
			this.#set({ ...row, values: chosen });
		};
		return html`<span class="values">${entry.options.map(
			(option, at) => html`<label class="toggle"><input
				type="checkbox" .checked=${live(values.includes(option))} aria-invalid=${problem && at === 0 ? "true" : nothing}
				aria-describedby=${this.idOf(`problem-${row.id}`)} @change=${() => toggle(option)}
			> ${optionLabel(entry, at)}</label>`,
		)}</span>`;
	}

	/** Renders a field for each colour, and buttons that add and remove one. */
	#colours({ label }: BatchSetting, row: FormRow): unknown {
		const { values } = row;
		const set = (colours: readonly string[]) => this.#set({ ...row, values: colours });
		return html`<span class="values">${values.map(
			(colour, at) => html`<input
				type="color" aria-label=${text("batch_colour", { setting: label, number: at + 1 })} .value=${live(`#${colour}`)}
				@change=${({ target }: Event) => set(values.with(at, (target as HTMLInputElement).value.slice(1).toLowerCase()))}
			>`,
		)}
			<button class="button" type="button" @click=${() => set([...values, values[values.length - 1]])}>${text("batch_add_colour")}</button>
			${values.length > 1 ? html`<button class="button" type="button" @click=${() => set(values.slice(0, -1))}>${text("batch_remove_colour")}</button>` : nothing}
		</span>`;
	}

	/** Adds a row for the first unused setting, basics first; the focus moves to its list of settings. */
	async #add(): Promise<void> {
		const { state } = this.context;
		const settings = this.#groups.flatMap((group) => group.settings);
		const basics = state.model.table.basics.flatMap(({ key }) => settings.find((each) => each.key === key) ?? []);
		const setting = [...basics, ...settings].find(({ key }) => !this.#isUsed(key));
		if (!setting) return;
		this.#rows = [...this.#rows, { ...rowFor(state, setting), id: ++this.#made }];
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector<HTMLElement>(".vary-row:last-of-type select")?.focus();
	}

	/** Removes a row; the focus moves to the row that takes its place, or to the button that adds one. */
	async #remove({ id }: FormRow): Promise<void> {
		const at = this.#rows.findIndex((row) => row.id === id);
		this.#rows = this.#rows.filter((row) => row.id !== id);
		this.requestUpdate();
		await this.updateComplete;
		const row = this.querySelectorAll(".vary-row")[at];
		(row?.querySelector("select") ?? this.querySelector<HTMLElement>("[data-add]"))?.focus();
	}

	/** Gives a row another setting. */
	#choose(row: FormRow, key: string): void {
		const setting = this.#setting(key);
		if (setting) this.#set({ ...rowFor(this.context.state, setting), id: row.id });
	}

	/** Replaces a row; its problem no longer applies. */
	#set({ problem: _, ...row }: FormRow): void {
		this.#rows = this.#rows.map((each) => (each.id === row.id ? row : each));
		this.requestUpdate();
	}
}

customElements.define("panicle-batch-rows", BatchRows);
