/** Splits text at a separator: `key=value`, `from..to`. */

/** The text before the first separator and the text after it, both trimmed; undefined without a separator. */
export function splitAtFirst(text: string, mark: string): readonly [before: string, after: string] | undefined {
	const at = text.indexOf(mark);
	return at < 0 ? undefined : [text.slice(0, at).trim(), text.slice(at + mark.length).trim()];
}

/** Splits `key=value`, where the key is one word. */
export function keyAndValue(text: string): readonly [key: string, value: string] | undefined {
	const halves = splitAtFirst(text, "=");
	return halves && halves[0] !== "" && !/\s/.test(halves[0]) ? halves : undefined;
}
