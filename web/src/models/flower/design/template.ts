/** Fills the gaps, `{{length}}`, of a template grammar. */

/**
 * Fills a template.
 * @param template its text, with names between `{{` and `}}`
 * @returns the text with every gap filled
 * @throws RangeError if a name has no value
 */
export function filled(template: string, values: Readonly<Record<string, string | number>>): string {
	return template.replace(/\{\{([a-z ]+)\}\}/g, (_, name: string) => {
		if (!Object.hasOwn(values, name)) throw new RangeError(`The template needs a value for ${name}.`);
		return String(values[name]);
	});
}
