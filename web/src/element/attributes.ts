/**
 * Reads the specimen from an element's attributes: `preset="riesling" seed="7" age="80"`, `model="leaf"`,
 * `link="?v=2&…"`.
 */
import { isModel, modelNamed } from "../models/index";
import type { PageModel } from "../models/page_model";
import { decodeLink, linkParts, modelInQuery } from "../specimen/link";
import { Notes, quote } from "../specimen/notes";
import { isKnown, type Restored, restore } from "../specimen/restore";
import { text } from "./messages.generated";

/** Attributes of the element itself, about display; no parameter has such a name. */
export const OWN_ATTRIBUTES = [
	"loading",
	"poster",
	"autorotate",
	"wind",
	"outdoors",
	"controls",
	"handles",
	"capture",
	"app",
	"theme",
	"alt",
] as const;
/** Attributes that select the model and the link that the others change. */
const START_ATTRIBUTES = ["model", "link"];

/** HTML's global attributes. Attributes of frameworks have characters in their names that no parameter has. */
const GLOBAL_ATTRIBUTES = new Set(
	"accesskey autofocus class contenteditable dir draggable enterkeyhint exportparts hidden id inert inputmode is itemid itemprop itemref itemscope itemtype lang nonce part popover role slot spellcheck style tabindex title translate writingsuggestions".split(
		" ",
	),
);
const FRAMEWORK_ATTRIBUTE = /[^a-z0-9_]|^_|^on/;

/** The specimen read from attributes, its model, and notes about attributes that could not be used. */
export interface AttributeReading extends Restored {
	readonly model: PageModel;
}

export type Attributes = Iterable<{ readonly name: string; readonly value: string }>;

/**
 * Reads attributes as links are read: unusable values are replaced by defaults, with a note. Other attributes override
 * values of the link.
 */
export async function readAttributes(attributes: Attributes): Promise<AttributeReading> {
	const values = Object.fromEntries([...attributes].map(({ name, value }) => [name, value]));
	const notes = new Notes();
	const link = values.link === undefined ? undefined : linkParts(values.link);
	const named = values.model ?? (link && modelInQuery(link.query));
	if (named !== undefined && !isModel(named))
		notes.add("model", text.message("model_unknown", { model: quote(named) }), text("default_model_used"));
	const model = await modelNamed(named);
	const record: Record<string, string> = {};
	for (const [name, value] of Object.entries(values)) {
		if (!isSpecimenAttribute(name) || START_ATTRIBUTES.includes(name)) continue;
		if (isKnown(model, name)) record[name] = value;
		else notes.add(name, text.message("attribute_unknown", { model: model.name }), text("attribute_ignored"));
	}
	const start = link && (await decodeLink(model, link.query, link.fragment));
	const read = restore(model, { model: model.name, ...record }, start?.specimen);
	return { model, specimen: read.specimen, notes: [...notes.all(), ...(start?.notes ?? []), ...read.notes] };
}

/** Returns whether an attribute of that name describes the specimen. */
export function isSpecimenAttribute(name: string): boolean {
	return !(OWN_ATTRIBUTES.some((own) => own === name) || GLOBAL_ATTRIBUTES.has(name) || FRAMEWORK_ATTRIBUTE.test(name));
}
