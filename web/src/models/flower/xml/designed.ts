/**
 * Converts XML to a flower's grammar. Since XML drops comments and spells lists out, sections that match their
 * description are regenerated.
 */
import { assembled, designOf, textOf } from "../design/design";
import { sectionOf } from "../design/sections";
import { textOfXml } from "./read";
import { xmlOf } from "./write";

/**
 * Returns the text of an XML file; unchanged sections of a design do not count as edited by hand.
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
