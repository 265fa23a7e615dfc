/** Number of derivation steps, in place of the text's own. */

import type { Field } from "../../../specimen/model_schema";
import { readWithin } from "../../../specimen/read_within";
import { text } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";

/** Limit of the core (wasm-core/src/foundation/limits.hpp). */
export const MAX_STEPS = 4096;
const STEPS = { kind: "integer", min: 0, max: MAX_STEPS } as const;

export const steps: Field<GrammarSpecimen> = {
	keys: ["steps"],
	settings: ["steps=N"],
	read: (specimen, key, value, notes) => {
		const read = readWithin(STEPS, key, value, text("own_steps"), notes);
		if (read !== undefined) specimen.steps = read;
	},
	query: ({ steps: own }, preset) => (own === undefined || own === preset.steps ? [] : [["steps", String(own)]]),
};
