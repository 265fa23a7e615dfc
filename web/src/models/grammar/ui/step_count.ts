/** Number of derivation steps, which the panel sets with a slider and a field. */
import { NO_PARAMETER, type Quantity } from "../../../ui/quantity";
import type { Tool } from "../../../ui/tool";
import { MAX_STEPS } from "../details/steps";
import type { GrammarPlant } from "../grammar_plant";
import { text } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";
import { fetchedText } from "../texts";
import { derivationLength } from "../written_text";

/** Steps beyond the grammar's own number to which the slider goes: many plants grow tenfold with each. */
const FURTHER = 4;
/** Number of steps that the slider offers where the grammar computes its own. */
const COMPUTED = 20;

/** Returns the number of steps in the text of a specimen; undefined if the text computes it or has none. */
function writtenSteps(specimen: GrammarSpecimen): number | undefined {
	const grammar = fetchedText(specimen) ?? "";
	const place = derivationLength(grammar);
	const steps = place ? Number(grammar.slice(place.from, place.to)) : Number.NaN;
	return Number.isInteger(steps) && steps >= 0 && steps <= MAX_STEPS ? steps : undefined;
}

/** Quantities by the greatest number of steps: the panel draws a quantity anew if it is another object. */
const quantities = new Map<number, Quantity<GrammarSpecimen, GrammarPlant>>();

function stepsUpTo(max: number): Quantity<GrammarSpecimen, GrammarPlant> {
	const known = quantities.get(max);
	if (known) return known;
	const quantity: Quantity<GrammarSpecimen, GrammarPlant> = {
		...NO_PARAMETER,
		key: "steps",
		kind: "integer",
		unit: "",
		min: 0,
		max,
		step: 1,
		get label() {
			return text("steps");
		},
		get help() {
			return text("steps_help");
		},
		read: (specimen, grown) => specimen.steps ?? writtenSteps(specimen) ?? grown?.counts.steps,
		change: (specimen, steps) => ({ details: { steps: steps === writtenSteps(specimen) ? undefined : steps } }),
	};
	quantities.set(max, quantity);
	return quantity;
}

export const stepCount: Tool<GrammarSpecimen, GrammarPlant> = {
	name: "step-count",
	initial: undefined,
	quantities: (specimen) => {
		const own = writtenSteps(specimen) ?? COMPUTED;
		return [stepsUpTo(Math.min(MAX_STEPS, Math.max(own + FURTHER, specimen.steps ?? 0)))];
	},
};
