/** Pseudo-translations, which show texts that are not in a catalogue and layouts that clip longer texts. */
import type { Translator } from "./locale";

const ACCENTED: Readonly<Record<string, string>> = {
	a: "á",
	e: "é",
	i: "í",
	o: "ó",
	u: "ú",
	n: "ñ",
	c: "ç",
	A: "Á",
	E: "É",
};

/** Lengthens a text by about 35 % and marks its ends, so that a clipped text shows: "Copy link" → "[Çópy líñk ~~~]". */
export const lengthen: Translator = (_code, _args, english) => {
	const accented = english.replace(/[aeiounc]/gi, (letter) => ACCENTED[letter] ?? letter);
	return `[${accented} ${"~".repeat(Math.ceil(english.length * 0.3))}]`;
};
