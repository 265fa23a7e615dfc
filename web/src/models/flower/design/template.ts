/** A template grammar and the values that fill its gaps, `{{length}}`. */

/**
 * @param template its text; between `{{` and `}}` stand names
 * @returns the text with every gap filled
 * @throws RangeError where a name has no value
 */
export function filled(template: string, values: Readonly<Record<string, string | number>>): string {
	return template.replace(/\{\{([a-z ]+)\}\}/g, (_, name: string) => {
		if (!Object.hasOwn(values, name)) throw new RangeError(`The template asks for ${name}, which nobody says.`);
		return String(values[name]);
	});
}
