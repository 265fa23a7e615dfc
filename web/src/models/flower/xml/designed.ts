/** A flower's grammar out of XML, which keeps no comments and spells lists out: what a design wrote is as the design writes it again. */
import { assembled, designOf, textOf } from "../design/design";
import { sectionOf } from "../design/sections";
import { textOfXml } from "./read";
import { xmlOf } from "./write";

/**
 * The text of a file of XML. Organs' sections that are what their descriptions make, but for that, are not taken for edited by hand.
 * @throws TextError with the line and column of the XML
 */
export function grammarOfXml(source: string): string {
	const text = textOfXml(source);
	const design = designOf(text);
	if (!design) return text;
	const descriptions = design.sections.map(({ description }) => description);
	const made = designOf(textOfXml(xmlOf(assembled(descriptions, design.head))));
	if (!made) return text;
	return textOf({
		...design,
		sections: design.sections.map((section, i) =>
			section.text.trim() === made.sections[i].text.trim()
				? { ...section, text: sectionOf(section.description) }
				: section,
		),
	});
}
