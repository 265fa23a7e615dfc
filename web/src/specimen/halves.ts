/** Splits text at a separator: `key=value`, `from..to`. */

/** Returns the text before the first separator and the text after it, both trimmed; undefined without a separator. */
export function splitAtFirst(text: string, mark: string): readonly [before: string, after: string] | undefined {
	const index = text.indexOf(mark);
	return index < 0 ? undefined : [text.slice(0, index).trim(), text.slice(index + mark.length).trim()];
}

/** Splits `key=value`; undefined where there is no `=`, or the key is not one word. */
export function keyAndValue(text: string): readonly [key: string, value: string] | undefined {
	const halves = splitAtFirst(text, "=");
	return halves && halves[0] !== "" && !/\s/.test(halves[0]) ? halves : undefined;
}
