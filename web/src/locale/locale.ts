/**
 * The language of all texts. English is in the code; other languages are catalogues that are loaded when they are
 * used. A page loads its language before it draws anything, and changes it by loading itself again.
 */

/** A language with a catalogue. */
export interface Language {
	/** The language's tag in links and settings: "fr". */
	readonly key: string;
	/** The tag for numbers, dates and plurals: "fr-FR". */
	readonly tag: string;
	/** The language's name in that language. */
	readonly name: string;
	/** The direction of its script. */
	readonly direction: "ltr" | "rtl";
	/** Loads the catalogue; absent for English. */
	load?(): Promise<Translator>;
}

/**
 * Translates a message.
 * @param code the room and the key: "app.copy_link"
 * @param args the arguments by name
 * @param english the English text
 * @returns the translation; undefined where the catalogue has none
 */
export type Translator = (
	code: string,
	args: Readonly<Record<string, unknown>> | undefined,
	english: string,
) => string | undefined;

const ENGLISH: Language = { key: "en", tag: "en-GB", name: "English", direction: "ltr" };

/** The languages that users can choose. */
export const LANGUAGES: readonly Language[] = [
	ENGLISH,
	{
		key: "fr",
		tag: "fr-FR",
		name: "Français",
		direction: "ltr",
		load: async () => (await import("./catalogue")).translatorOf((await import("./fr.generated")).catalogue),
	},
];

/**
 * Languages that test layouts: "en-XA" lengthens every text by at least 30 %, "ar-XB" also runs from right to left.
 * They are never chosen by themselves.
 */
const PSEUDO_LANGUAGES: readonly Language[] = [
	{
		key: "en-XA",
		tag: "en-GB",
		name: "Pseudo (long)",
		direction: "ltr",
		load: async () => (await import("./pseudo")).lengthen,
	},
	{
		key: "ar-XB",
		tag: "en-GB",
		name: "Pseudo (right to left)",
		direction: "rtl",
		load: async () => (await import("./pseudo")).lengthen,
	},
];

let language = ENGLISH;
let translator: Translator | undefined;

/** Returns the language in use. */
export const currentLanguage = (): Language => language;

/** Returns the tag for `Intl`: "en-GB". */
export const localeTag = (): string => language.tag;

/** Returns the language of a tag such as "fr-CA"; undefined where it has no catalogue. */
export function languageOf(tag: string): Language | undefined {
	const all = [...LANGUAGES, ...PSEUDO_LANGUAGES];
	return all.find(({ key }) => key === tag) ?? LANGUAGES.find(({ key }) => tag.toLowerCase().split("-")[0] === key);
}

/**
 * Returns the first language of a list of tags, in the order of preference, that has a catalogue; English where none
 * has.
 */
export const preferredLanguage = (tags: readonly string[]): Language =>
	tags.map(languageOf).find((found) => found !== undefined) ?? ENGLISH;

/**
 * Loads a language and uses it from now on. Texts that are shown already stay as they are. Where the catalogue cannot
 * be fetched, English stays.
 */
export async function useLanguage(next: Language): Promise<void> {
	try {
		translator = await next.load?.();
		language = next;
	} catch {
		translator = undefined;
		language = ENGLISH;
	}
}

/** Returns the translation of a text; the English text where there is none. */
export const translated = (code: string, english: string, args?: Readonly<Record<string, unknown>>): string =>
	translator?.(code, args, english) ?? english;
