/** Reads a model's grammars, and computes the changes that edit them in the document. */
import type { Plant } from "../plant/plant";
import {
	type ConstantValues,
	isStorableConstant,
	MAX_CONSTANTS,
	sortedConstants,
	type WithConstants,
} from "../specimen/constants";
import type { WithGrammar } from "../specimen/grammar_text";
import type { Specimen } from "../specimen/specimen";
import type { Change, EditorContext } from "../ui/editor_context";
import type { Dialect } from "./dialect";
import { type Constant, withConstants } from "./outline";
import { readOutline } from "./read_outline";

/** Describes a model's grammars for the editor. */
export interface GrammarSource<S extends Specimen & WithGrammar = Specimen & WithGrammar> {
	/** Name of a plant in sentences: "bunch". */
	readonly plantName: string;
	/**
	 * Key of the panel group that shows the notice about a document's own grammar; absent: a group at the end of the
	 * panel, because handles write texts.
	 */
	readonly group?: string;
	/**
	 * Returns the built-in text for a document, or a promise while the text loads; after the promise resolves, call
	 * again.
	 */
	builtIn(specimen: S): string | Promise<unknown>;
	/** Language of the texts; defaults to L-systems. */
	readonly dialect?: Dialect;
	/** The names that `#role` takes. */
	readonly roles?: readonly string[];
	/** False if the texts have no constants. */
	readonly constants?: false;
	/** Whether sliders for constants are shown before the document has its own text. */
	readonly always?: boolean;
	/** Returns how many constants the panel shows among the basics, at most; absent: none. */
	basics?(specimen: S): number;
	/** Returns the label and the unit of a constant among the basics, in the language in use; by default its name. */
	label?(name: string): { readonly label: string; readonly unit?: string } | undefined;
	/**
	 * Name of the constant that bends a stem: above the middle of its range to the right of a plant seen from in
	 * front.
	 */
	readonly leans?: string;
	/** Constants set by parameters of the table, which have sliders already. */
	readonly governed?: ReadonlySet<string>;
	/** Returns warnings about missing parts of a plant, one line each; shown below the text. */
	warnings?(grown: Plant, specimen: S): readonly string[];
	/**
	 * Returns the constants' values of a preset, for documents that store such values (specimen/constants.ts): sliders
	 * then leave the text unchanged.
	 */
	presetConstants?(preset: string): ConstantValues;
}

/**
 * Returns a document's text with the values of its constants; undefined while the text loads, in which case `later` is
 * called afterwards.
 */
export function textOf(source: GrammarSource, specimen: Specimen & WithGrammar, later: () => void): string | undefined {
	const text = specimen.grammar ?? source.builtIn(specimen);
	if (typeof text === "string")
		return source.presetConstants ? substituteValues(source, text, constantsOf(specimen)) : text;
	text.then(later, () => {}); // The code that grows the plant reports why the text did not load.
	return undefined;
}

/** Returns the constants among the panel's basics: the first of a text that have a written range and no parameter. */
export function basicConstants<S extends Specimen & WithGrammar>(
	{ basics, governed }: Pick<GrammarSource<S>, "basics" | "governed">,
	specimen: S,
	constants: readonly Constant[],
): readonly Constant[] {
	const free = constants.filter(({ name, isRanged }) => isRanged && !governed?.has(name));
	return free.slice(0, basics?.(specimen) ?? 0);
}

/**
 * Returns the label and the unit of a constant among the basics: those of the source, else the name with a capital, unless
 * it is a symbol of one or two letters.
 */
export function labelOf(
	{ label }: Pick<GrammarSource, "label">,
	{ name, unit }: Pick<Constant, "name" | "unit">,
): { readonly label: string; readonly unit: string } {
	const capitalised = /^[a-z]{3,}$/.test(name) ? name.charAt(0).toUpperCase() + name.slice(1) : name;
	return { label: capitalised, unit, ...label?.(name) };
}

/** Returns whether a document has its own text. */
export function isOwn({ grammar }: WithGrammar): boolean {
	return grammar !== undefined;
}

/**
 * Returns the change that sets the document's text; undefined restores the built-in text. A text that differs from the
 * built-in one only in numbers of constants is stored as constants. Values of names that the document's own text
 * defines are stored in the text only.
 */
export function withText(source: GrammarSource, specimen: Specimen & WithGrammar, text: string | undefined): Change {
	const { presetConstants } = source;
	const builtIn = source.builtIn(specimen);
	if (!presetConstants) return { details: { grammar: text === builtIn ? undefined : text } };
	const published = presetConstants(specimen.preset);
	if (text === undefined) return { details: { grammar: text, constants: published } };
	const { constants, definitions } = readOutline(text, source.dialect);
	const defined = new Set(definitions.map(({ name }) => name));
	const otherValues = Object.entries(constantsOf(specimen)).filter(([name]) => !defined.has(name));
	if (typeof builtIn === "string") {
		const builtInValues = new Map(definitionsOf(source, builtIn));
		const changedValues = constants
			.filter(
				({ name, number }) =>
					!source.governed?.has(name) && (Object.hasOwn(published, name) || builtInValues.get(name) !== number.text),
			)
			.map(({ name, number }) => [name, number.value] as const);
		const allValues = sortedConstants([...otherValues, ...changedValues]);
		if (areStorable(allValues) && text === substituteValues(source, builtIn, allValues))
			return { details: { grammar: undefined, constants: allValues } };
	}
	return { details: { grammar: text, constants: Object.fromEntries(otherValues) } };
}

/**
 * Returns the change that sets constants: stored beside a preset's text, which stays the preset's, or else written
 * into the text. Undefined while the text loads.
 */
export function withValues(
	source: GrammarSource,
	specimen: Specimen & WithGrammar,
	values: ConstantValues,
): Change | undefined {
	const text = textOf(source, specimen, () => {});
	if (text === undefined) return undefined;
	const { presetConstants } = source;
	if (!presetConstants || isOwn(specimen))
		return withText(source, specimen, withConstants(text, values, readOutline(text, source.dialect).pieces));
	const published = presetConstants(specimen.preset);
	const builtIn = source.builtIn(specimen) as string;
	const builtInValues = new Map(readOutline(builtIn, source.dialect).constants.map((each) => [each.name, each.number]));
	// Values equal to the built-in text's are not stored.
	const changedValues = Object.entries({ ...constantsOf(specimen), ...values }).filter(
		([name, value]) => Object.hasOwn(published, name) || builtInValues.get(name)?.value !== value,
	);
	const constants = sortedConstants(changedValues);
	if (areStorable(constants)) return { details: { constants } };
	return withText(source, specimen, withConstants(text, values, readOutline(text, source.dialect).pieces));
}

/** Returns whether links can store the values; a text can contain any. */
const areStorable = (constants: ConstantValues): boolean => {
	const entries = Object.entries(constants);
	return entries.length <= MAX_CONSTANTS && entries.every(([name, value]) => isStorableConstant(name, value));
};

/** Returns the definitions of a text: name and value as written. */
const definitionsOf = ({ dialect }: GrammarSource, text: string) =>
	readOutline(text, dialect).definitions.map(({ name, from, to }) => [name, text.slice(from, to)] as const);

/** Returns the values that a document stores for constants of its text. */
const constantsOf = (specimen: Specimen & Partial<WithConstants>): ConstantValues => specimen.constants ?? {};

/** Cache of texts with substituted values, by the values: needed at every drawing. */
const valuedTexts = new WeakMap<ConstantValues, { readonly text: string; readonly valued: string }>();

/** Returns a text with the values of constants written in, except governed ones. */
function substituteValues({ dialect, governed }: GrammarSource, text: string, constants: ConstantValues): string {
	const cached = valuedTexts.get(constants);
	if (cached?.text === text) return cached.valued;
	const changeable = Object.entries(constants).filter(([name]) => !governed?.has(name));
	const substituted =
		changeable.length === 0
			? text
			: withConstants(text, Object.fromEntries(changeable), readOutline(text, dialect).pieces);
	valuedTexts.set(constants, { text, valued: substituted });
	return substituted;
}

/** Editor context of models with a grammar. */
export type GrammarContext = EditorContext<Specimen & WithGrammar>;
