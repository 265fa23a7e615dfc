import { expect, it } from "vitest";
import { applying, groupsFor } from "../../../web/src/app/panel_groups";
import { outlineOf } from "../../../web/src/grammar_editor/outline";
import { basicConstants, type GrammarSource } from "../../../web/src/grammar_editor/source";
import type { FlowerSpecimen } from "../../../web/src/models/flower/specimen";
import { BASIC_FIELDS } from "../../../web/src/models/flower/ui/design/design_panel";
import { isDesigned } from "../../../web/src/models/flower/ui/design/design_tool";
import { basicFlowerConstants } from "../../../web/src/models/flower/ui/ui";
import { source as grammar } from "../../../web/src/models/grammar/ui/text";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../web/src/specimen/specimen";
import { isQuantity } from "../../../web/src/ui/quantity";
import { BASICS } from "../../../web/src/ui/tool";

/** Models with fewer basics than five, because their tables have few parameters. */
const FEWER: Readonly<Record<string, { readonly least: number; readonly reason: string }>> = {
	stand: { least: 3, reason: "The table has four parameters; the plants are in the text." },
	flower: { least: 2, reason: "The table has three parameters; the others are constants of some texts." },
};

/** Rows that tools draw among the basics, besides parameters and quantities. */
const DRAWN: Readonly<Record<string, (specimen: Specimen) => number>> = {
	grammar: (specimen) => constantsIn(grammar as unknown as GrammarSource, specimen),
	flower: (specimen) =>
		isDesigned(specimen as FlowerSpecimen)
			? BASIC_FIELDS.length
			: constantsIn(basicFlowerConstants as unknown as GrammarSource, specimen),
};

function constantsIn(source: GrammarSource, specimen: Specimen): number {
	return basicConstants(source, specimen, outlineOf(String(source.builtIn(specimen))).constants).length;
}

it.each(modelNames())("a plant of the model %s has five to seven basics", async (name) => {
	const model = await modelNamed(name);
	const ui = await model.ui?.();
	const { least } = FEWER[name] ?? { least: 5 };
	const counts = new Map<string, number>();
	for (const { name: preset } of model.presets.list) {
		const specimen = fromPreset(model, preset);
		await model.prepare?.(specimen);
		const [basics] = groupsFor(model.table, specimen, applying(ui?.tools, specimen));
		expect(basics.group.key).toBe(BASICS);
		const shown = basics.entries.filter((entry) => !isQuantity(entry) || entry.read(specimen, undefined) !== undefined);
		counts.set(preset, shown.length + (DRAWN[name]?.(specimen) ?? 0));
	}
	expect([...counts].filter(([, count]) => count < least || count > 7)).toEqual([]);
});
