/** `<panicle-flower-organs>`: the six organs as tabs, each with controls for its fields. */

import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { formatNumber } from "../../../../locale/format";
import { chooseFile } from "../../../../ui/choose_file";
import { ControlElement } from "../../../../ui/control_element";
import type { Stateful } from "../../../../ui/editor_context";
import { HeldKey } from "../../../../ui/held_key";
import { PICTURES } from "../../../../ui/picture_file";
import { sliderRow } from "../../../../ui/slider_row";
import { refusal } from "../../../../ui/typed";
import { outlineOf } from "../../design/blade";
import { isEdited, madeAnew } from "../../design/choose";
import { type Description, described } from "../../design/description";
import { type Design, describedIn } from "../../design/design";
import { FIELDS, type NumberField, ORGANS, type Organ, type OrganField } from "../../design/organs";
import { DRAWN } from "../../design/shapes";
import { text as message } from "../../messages.generated";
import { type Drafts, descriptionsIn, designIn, type FlowerContext, textChange } from "./drafts";
import { floralFormula } from "./floral_diagram";
import { pointsOf } from "./outline_scene";
import { traceInto } from "./trace";

/** Fields that are hidden while they have no effect. */
const HIDDEN_WHEN: Readonly<Record<string, (values: Description["values"]) => boolean>> = {
	lip: ({ symmetry }) => symmetry !== "irregular",
};

/** Fields among the panel's basics, with names that include the organ. */
export const BASIC_FIELDS = [
	["petal", "count", () => message("basic_petals")],
	["petal", "length", () => message("basic_petal_length")],
	["petal", "width", () => message("basic_petal_width")],
	["petal", "tip", () => message("basic_petal_colour")],
	["stem", "length", () => message("basic_stem_length")],
] as const;

class OrgansPanel extends ControlElement<FlowerContext> {
	static override properties = {
		...ControlElement.properties,
		tool: { attribute: false },
		drafts: { attribute: false },
		basics: { attribute: false },
	};
	declare tool: Stateful<Organ>;
	declare drafts: Drafts;
	/** Whether to show the basic fields of all organs, in place of an organ's own. */
	declare basics: boolean;

	/** The last typed number that was changed to fit its field, with the message that explains it. */
	#refused: { readonly of: string; readonly value: number; readonly text: string } | undefined;
	readonly #held = new HeldKey(() => this.drafts.settle(this.context));

	/** Returns the values whose change redraws the panel: the design or the selected organ. */
	protected override shows({ state, toolState }: FlowerContext): readonly unknown[] {
		return [designIn(state.specimen), toolState.call(this.context, this.tool)];
	}

	/** Draws the panel; nothing for a text without a design. */
	protected override draw(context: FlowerContext): unknown {
		const design = designIn(context.state.specimen);
		if (!design) return nothing;
		return this.basics
			? BASIC_FIELDS.map(([organ, key, label]) => this.#basicField(design, organ, key, label()))
			: this.#draw(design);
	}

	/** Draws a field of an organ under another name. */
	#basicField(design: Design, organ: Organ, key: string, label: string): unknown {
		const field = FIELDS[organ].find((each) => each.key === key);
		return field && this.#field(describedIn(design, organ), { ...field, label });
	}

	/** Draws the floral formula, the choice of the organ, and the organ's fields. */
	#draw(design: Design): unknown {
		const organ = this.context.toolState(this.tool);
		const description = describedIn(design, organ);
		const edited = design.sections.some((section) => section.description.organ === organ && isEdited(section));
		return html`<p><abbr title=${message("floral_formula")}>${floralFormula(descriptionsIn(design))}</abbr></p>
			<div class="segments" role="radiogroup" aria-label=${message("organ")} .style=${"display: grid; grid-template-columns: repeat(3, 1fr)"}>
				${ORGANS.map(
					(each) => html`<label><input
						type="radio" name=${this.idOf("organ")} .checked=${live(each === organ)}
						@change=${() => this.context.setToolState(this.tool, each)}
					>${message(each)}</label>`,
				)}
			</div>
			<div role="group" aria-label=${message(organ)}>
				${FIELDS[organ]
					.filter(({ key }) => !HIDDEN_WHEN[key]?.(description.values))
					.map((field) => this.#field(description, field))}
				${description.values.outline === undefined ? nothing : this.#outline(description)}
			</div>
			${
				edited
					? html`<p>${message("edited_by_hand")}</p>
						<div class="actions"><button
							class="button" type="button" @click=${() => this.context.set(textChange(this.context.state.specimen, madeAnew(design, organ)))}
						>${message("rebuild")}</button></div>`
					: nothing
			}`;
	}

	/** Draws a field of an organ: a slider, a choice or a colour. */
	#field(description: Description, field: OrganField): unknown {
		const { key, label, help } = field;
		const id = this.idOf(`${description.organ}-${key}`);
		const value = description.values[key];
		if (field.kind === "number")
			return html`<div class="control">${this.#number(description, field, id)}</div>
				${this.#refused?.of === `${description.organ} ${key}` && this.#refused.value === value ? html`<p class="clamped" role="status">${this.#refused.text}</p>` : nothing}`;
		const words = html`<label for=${id}>${label}</label>`;
		const helpText = html`<panicle-info .name=${label} .text=${help}></panicle-info>
			<span class="unseen" id=${`${id}-help`}>${help}</span>`;
		if (field.kind === "choice")
			return html`<div class="control choice">${words}
				<select id=${id} .value=${live(String(value))} aria-describedby=${`${id}-help`}
					@change=${(event: Event) => this.#choose(description, key, (event.target as HTMLSelectElement).value)}
				>${field.options.map((option) => html`<option value=${option} ?selected=${option === value}>${message("option", { option })}</option>`)}</select>
				${helpText}</div>`;
		return html`<div class="control choice">${words}
			<input type="color" id=${id} .value=${live(`#${value}`)} aria-describedby=${`${id}-help`}
				@input=${(event: Event) => this.#edit(description, key, digits(event))}
				@change=${(event: Event) => this.#choose(description, key, digits(event))}
			>${helpText}</div>`;
	}

	/** Draws the slider of an organ's number. */
	#number(description: Description, { key, label, unit, least, most, step, help }: NumberField, id: string): unknown {
		const value = Number(description.values[key]);
		const range = unit ? message("range_unit", { least, most, unit }) : message("range", { least, most });
		return sliderRow({
			id,
			label,
			name: label,
			typedName: message("typed", { name: label }),
			min: least,
			max: most,
			step,
			value,
			text: String(value),
			unit,
			spoken: `${value} ${unit}`.trim(),
			help: message("help_and_range", { help, range }),
			held: this.#held,
			slide: (newValue) => this.#edit(description, key, newValue, this.#held.run),
			type: (typed, text) => {
				if (Number.isFinite(typed)) this.#choose(description, key, typed);
				const accepted = this.#valueOf(description.organ, key) ?? value;
				this.#explain(
					description.organ,
					key,
					accepted,
					accepted === typed ? undefined : refusal(label, range, text, typed, String(accepted)),
				);
				return String(accepted);
			},
		});
	}

	/** Returns the current value of an organ's number in the flower's text; undefined without a design. */
	#valueOf(organ: Organ, key: string): number | undefined {
		const design = designIn(this.context.state.specimen);
		return design && Number(describedIn(design, organ).values[key]);
	}

	/**
	 * Shows below a field why the typed number was refused or changed.
	 * @param value the number that the field has now; once it changes, the message disappears
	 * @param message undefined where the number was accepted as typed, which removes the message
	 */
	#explain(organ: Organ, key: string, value: number, message: string | undefined): void {
		this.#refused = message === undefined ? undefined : { of: `${organ} ${key}`, value, text: message };
		this.requestUpdate();
	}

	/** Shows how closely the polynomial fits the outline, and a button to trace a picture. */
	#outline(description: Description): unknown {
		const { organ } = description;
		const { error } = outlineOf(description);
		return html`<p>
				${message.pieces("fit", { error: html`<output>${formatNumber(100 * error, TENTHS)} %</output>` })}
			</p>
			<div class="actions">${chooseFile({
				accept: PICTURES,
				label: message("picture", { organ }),
				caption: message("trace"),
				take: (file) => void traceInto(this.context, this.drafts, organ, file),
			})}</div>`;
	}

	/** Returns an organ's description with one value changed; a drawn outline starts from the shape chosen before. */
	#with(description: Description, key: string, value: string | number): Description {
		const margin = key === "outline" && value === DRAWN ? pointsOf(description) : description.margin;
		return described(description, { [key]: value }, margin);
	}

	/** Sets a value as a finished change: one undo step. */
	#choose(description: Description, key: string, value: string | number): void {
		this.drafts.set(this.context, this.#with(description, key, value));
	}

	/**
	 * Sets a value while a slider or a colour is dragged. Such drafts become one undo step when `Drafts.settle` is called.
	 * @param run identifies the key that is held down: its repeated changes are one undo step, too
	 */
	#edit(description: Description, key: string, value: string | number, run?: string): void {
		const design = designIn(this.context.state.specimen);
		if (!design) return;
		const changed = this.#with(description, key, value);
		const all = descriptionsIn(design).map((each) => (each.organ === changed.organ ? changed : each));
		this.drafts.edit(this.context, all, run);
	}
}

const TENTHS = { minimumFractionDigits: 1, maximumFractionDigits: 1 } as const;
/** Returns the six digits of a colour input's value. */
const digits = (event: Event): string => (event.target as HTMLInputElement).value.slice(1).toLowerCase();

customElements.define("panicle-flower-organs", OrgansPanel);
