/** Counts that follow from the sources, for figures in the documentation: models, presets, parameters, mutants, frozen links. */
import { readFileSync } from "node:fs";
import { modelNamed, modelNames } from "../../web/src/models/index";
import { groups } from "../mutants/list/index.mjs";
import { mutantsOf } from "../mutants/mutants.mjs";

const models = await Promise.all(modelNames().map((name) => modelNamed(name)));
const { frozen } = JSON.parse(readFileSync("tests/golden/links/links.json", "utf8"));

/** By the names of the figures. */
export const counts: Readonly<Record<string, number>> = {
	models: models.length,
	presets: models.reduce((sum, { presets }) => sum + presets.list.length, 0),
	mutants: mutantsOf(groups).length,
	"frozen links": frozen.length,
	...Object.fromEntries(
		models.flatMap(({ name, presets, table }) => [
			[`presets of ${name}`, presets.list.length],
			[`parameters of ${name}`, table.entries.length],
			[`measures of ${name}`, table.measures.length],
		]),
	),
};
