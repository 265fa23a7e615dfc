/** `<panicle-flower-organs>`: the six organs as tabs, each with controls for its fields. */
import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
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
import { type Drafts, descriptionsIn, designIn, type FlowerContext, textChange } from "./drafts";
import { floralFormula } from "./floral_diagram";
import { pointsOf } from "./outline_scene";
import { traceInto } from "./trace";

const WORDS: Readonly<Record<Organ, string>> = {
	stem: "Stem",
	leaf: "Leaf",
	sepal: "Sepal",
	petal: "Petal",
	stamen: "Stamen",
	pistil: "Pistil",
};

/** Fields that are hidden while they have no effect. */
const HIDDEN_WHEN: Readonly<Record<string, (values: Description["values"]) => boolean>> = {
	lip: ({ symmetry }) => symmetry !== "irregular",
};

class OrgansPanel extends ControlElement<FlowerContext> {
	static override properties = {
		...ControlElement.properties,
		tool: { attribute: false },
		drafts: { attribute: false },
	};
	declare tool: Stateful<Organ>;
	declare drafts: Drafts;

	/** The last typed number that was changed to fit its field, with the message that explains it. */
	#refused: { readonly of: string; readonly value: number; readonly text: string } | undefined;
	readonly #held = new HeldKey(() => this.drafts.settle(this.context));

	protected override shows({ state, toolState }: FlowerContext): readonly unknown[] {
		return [designIn(state.specimen), toolState.call(this.context, this.tool)];
	}

	protected override draw(context: FlowerContext): unknown {
		const design = designIn(context.state.specimen);
		return design ? this.#draw(design) : nothing;
	}

	#draw(design: Design): unknown {
		const organ = this.context.toolState(this.tool);
		const description = describedIn(design, organ);
		const edited = design.sections.some((section) => section.description.organ === organ && isEdited(section));
		return html`<p><abbr title="Floral formula">${floralFormula(descriptionsIn(design))}</abbr></p>
			<div class="segments" role="radiogroup" aria-label="Organ" .style=${"display: grid; grid-template-columns: repeat(3, 1fr)"}>
				${ORGANS.map(
					(each) => html`<label><input
						type="radio" name=${this.idOf("organ")} .checked=${live(each === organ)}
						@change=${() => this.context.setToolState(this.tool, each)}
					>${WORDS[each]}</label>`,
				)}
			</div>
			<div role="group" aria-label=${WORDS[organ]}>
				${FIELDS[organ]
					.filter(({ key }) => !HIDDEN_WHEN[key]?.(description.values))
					.map((field) => this.#field(description, field))}
				${description.values.outline === undefined ? nothing : this.#outline(description)}
			</div>
			${
				edited
					? html`<p>Its grammar was edited by hand; choices leave that where they can.</p>
						<div class="actions"><button
							class="button" type="button" @click=${() => this.context.set(textChange(this.context.state.specimen, madeAnew(design, organ)))}
						>Write its grammar anew</button></div>`
					: nothing
			}`;
	}

	#field(description: Description, field: OrganField): unknown {
		const { key, label, help } = field;
		const id = this.idOf(key);
		const value = description.values[key];
		if (field.kind === "number")
			return html`<div class="control">${this.#number(description, field, id)}</div>
				${this.#refused?.of === `${description.organ} ${key}` && this.#refused.value === value ? html`<p class="clamped" role="status">${this.#refused.text}</p>` : nothing}`;
		const words = html`<label for=${id}>${label}</label>`;
		const helpText = html`<span class="unseen" id=${`${id}-help`}>${help}</span>`;
		if (field.kind === "choice")
			return html`<div class="control choice">${words}
				<select id=${id} .value=${live(String(value))} aria-describedby=${`${id}-help`}
					@change=${(event: Event) => this.#choose(description, key, (event.target as HTMLSelectElement).value)}
				>${field.options.map((option) => html`<option value=${option} ?selected=${option === value}>${inWords(option)}</option>`)}</select>
				${helpText}</div>`;
		return html`<div class="control choice">${words}
			<input type="color" id=${id} .value=${live(`#${value}`)} aria-describedby=${`${id}-help`}
				@input=${(event: Event) => this.#edit(description, key, digits(event))}
				@change=${(event: Event) => this.#choose(description, key, digits(event))}
			>${helpText}</div>`;
	}

	#number(description: Description, { key, label, unit, least, most, step, help }: NumberField, id: string): unknown {
		const value = Number(description.values[key]);
		const range = `${least} … ${most}${unit && ` ${unit}`}.`;
		return sliderRow({
			id,
			label,
			typedName: `${label}, typed`,
			min: least,
			max: most,
			step,
			value,
			text: String(value),
			unit,
			spoken: `${value} ${unit}`.trim(),
			help: `${help} ${range}`,
			held: this.#held,
			slide: (to) => this.#edit(description, key, to, this.#held.run),
			type: (typed, text) => {
				if (Number.isFinite(typed)) this.#choose(description, key, typed);
				const design = designIn(this.context.state.specimen);
				const taken = design ? Number(describedIn(design, description.organ).values[key]) : value;
				const refused = {
					of: `${description.organ} ${key}`,
					value: taken,
					text: refusal(label, range, text, typed, String(taken)),
				};
				this.#refused = taken === typed ? undefined : refused;
				this.requestUpdate();
				return String(taken);
			},
		});
	}

	/** Shows how closely the polynomial fits the outline, and a button to trace a picture. */
	#outline(description: Description): unknown {
		const { organ } = description;
		const { error } = outlineOf(description);
		return html`<p>
				A polynomial of degree 6 follows the outline within <output>${(100 * error).toFixed(1)} %</output> of its width. Drag
				its points, or trace a picture.
			</p>
			<div class="actions">${chooseFile({
				accept: PICTURES,
				label: `Picture of a ${organ}`,
				words: "Trace a picture…",
				take: (file) => void traceInto(this.context, this.drafts, organ, file),
			})}</div>`;
	}

	#with(description: Description, key: string, value: string | number): Description {
		// Drawing starts from the outline before.
		const margin = key === "outline" && value === DRAWN ? pointsOf(description) : description.margin;
		return described(description, { [key]: value }, margin);
	}

	#choose(description: Description, key: string, value: string | number): void {
		this.drafts.set(this.context, this.#with(description, key, value));
	}

	#edit(description: Description, key: string, value: string | number, run?: string): void {
		const design = designIn(this.context.state.specimen);
		if (!design) return;
		const changed = this.#with(description, key, value);
		const all = descriptionsIn(design).map((each) => (each.organ === changed.organ ? changed : each));
		this.drafts.edit(this.context, all, run);
	}
}

const inWords = (option: string): string => option.charAt(0).toUpperCase() + option.slice(1);
const digits = (event: Event): string => (event.target as HTMLInputElement).value.slice(1).toLowerCase();

customElements.define("panicle-flower-organs", OrgansPanel);
