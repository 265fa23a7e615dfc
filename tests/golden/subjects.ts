/** The plants of which native_wasm.test.ts compares every column, by model. */
import type { Block } from "../../web/src/core/container";
import { PRESETS as grammarPresets } from "../../web/src/models/grammar/presets.generated";
import type { GrowthOptions, Model } from "../../web/src/models/model";
import { fromPreset } from "../../web/src/specimen/from_preset";

export interface Subject {
	readonly name: string;
	/** Whether `npm test` grows it too; `npm run test:long` grows all of them. */
	readonly inGate: boolean;
	readonly request: readonly Block[];
}

/** A preset with some of its parameters changed. */
interface Growth {
	readonly preset: string;
	/** The version of the link that names the preset; the newest where absent. */
	readonly version?: number;
	readonly change?: Readonly<Record<string, number>>;
	readonly options?: GrowthOptions;
}

interface Row {
	growths(presets: readonly string[]): readonly Growth[];
	/** Subjects by name that have between them every column of the model: a test checks that. */
	readonly gate: readonly string[];
}

/** Every preset, and the first one with a further change. */
const everyPreset =
	(change: Growth["change"], ofFirst: Growth["change"]): Row["growths"] =>
	(presets) => [
		...presets.map((preset) => ({ preset, change })),
		{ preset: presets[0], change: { ...change, ...ofFirst } },
	];

const BUNCHES: readonly Growth[] = [
	{ preset: "long-conical" },
	{ preset: "double-bunch-winged" },
	{ preset: "redcurrant" },
	{ preset: "rubus" },
	{ preset: "pizzutello" },
	{ preset: "riesling", change: { leaves: 3, cane: 1 } },
];

/** Presets with a grammar of their own, but for two of very many modules, which take as long as all the others together. */
const GRAMMARS = grammarPresets.filter(
	({ name, text }) => name === text && !["compound-leaf", "flower-field"].includes(name),
);

const ROWS: Readonly<Record<string, Row>> = {
	bunch: {
		growths: () => [
			...["long-conical", "double-bunch-winged", "redcurrant"].map((preset) => ({ preset, version: 1 })),
			...BUNCHES.flatMap((each) => [0, 30, 60, 100, 125].map((age) => ({ ...each, change: { ...each.change, age } }))),
		],
		gate: ["double-bunch-winged, link version 1", "long-conical, age 0"],
	},
	leaf: { growths: everyPreset({ particles: 400 }, { age: 45 }), gate: ["grapevine, particles 400, age 45"] },
	tree: {
		growths: everyPreset({ particles: 400 }, { age: 45 }),
		gate: ["oak, particles 400", "oak, particles 400, age 45"],
	},
	root: { growths: everyPreset({ particles: 400 }, { age: 45 }), gate: ["tap, particles 400, age 45"] },
	growth: {
		growths: (presets) => [
			...everyPreset({ steps: 6 }, { age: 70 })(presets),
			{ preset: presets[0], change: { steps: 6 }, options: { levels: true } },
		],
		gate: ["apple, steps 6", "apple, steps 6, levels"],
	},
	flower: {
		// The map of a flower is large: of one preset it is enough.
		growths: (presets) => [
			{ preset: presets[0], options: { map: true } },
			{ preset: presets[0], change: { age: 0.4 }, options: { map: true } },
			{ preset: presets[0], options: { levels: true } },
			...presets.slice(1).map((preset) => ({ preset, options: { map: false } })),
		],
		gate: ["bluebell, map", "bluebell, levels"],
	},
	grammar: {
		growths: () => GRAMMARS.map(({ name }) => ({ preset: name })),
		gate: ["rose-campion", "bush", "capitulum"],
	},
	stand: { growths: (presets) => presets.map((preset) => ({ preset })), gate: ["vineyard"] },
};

/** A model that has no row: every preset, and the first one in the gate. */
const defaultRow = (presets: readonly string[]): Row => ({
	growths: () => presets.map((preset) => ({ preset })),
	gate: presets.slice(0, 1),
});

function nameOf({ preset, version, change = {}, options = {} }: Growth): string {
	const changes = Object.entries(change).map(([key, value]) => `${key} ${value}`);
	const outputs = Object.entries(options).flatMap(([key, wanted]) => (wanted ? [key] : []));
	return [preset, ...(version ? [`link version ${version}`] : []), ...changes, ...outputs].join(", ");
}

export async function subjectsOf(model: Model): Promise<Subject[]> {
	const presets = model.presets.list.map(({ name }) => name);
	const { growths, gate } = ROWS[model.name] ?? defaultRow(presets);
	const subjects = growths(presets).map(async (growth): Promise<Subject> => {
		const specimen = fromPreset(model, growth.preset, growth.version);
		Object.assign(specimen.parameters, growth.change);
		await model.prepare?.(specimen);
		const name = nameOf(growth);
		const request = model.encode(specimen, { meshFingerprint: true, ...growth.options } as GrowthOptions);
		return { name, inGate: gate.includes(name), request };
	});
	const found = await Promise.all(subjects);
	const missing = gate.filter((name) => !found.some((subject) => subject.name === name));
	if (missing.length > 0) throw new Error(`${model.name} has no subject “${missing.join("”, “")}”.`);
	return found;
}
