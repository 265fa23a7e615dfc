/** The specimen that an element's attributes say: `preset="riesling" seed="7" age="80"`, `model="leaf"`, `link="?v=2&…"`. */
import { isModel, modelNamed } from "../models/index";
import type { PageModel } from "../models/page_model";
import { decodeLink, linkParts, modelInQuery } from "../specimen/link";
import { Notes } from "../specimen/notes";
import { isKnown, type Restored, restore } from "../specimen/restore";

/** Attributes of the element that say what is done with the plant; no parameter is called so. */
export const OWN_ATTRIBUTES = [
	"loading",
	"poster",
	"autorotate",
	"wind",
	"controls",
	"handles",
	"app",
	"theme",
	"alt",
] as const;
/** Those that say where it starts from. */
const STARTS = ["model", "link"];

/** Every element's. Those of frameworks have a dash, a colon or something else in their names that no parameter has. */
const OF_PAGES = new Set(
	"accesskey autofocus class contenteditable dir draggable enterkeyhint exportparts hidden id inert inputmode is itemid itemprop itemref itemscope itemtype lang nonce part popover role slot spellcheck style tabindex title translate writingsuggestions".split(
		" ",
	),
);
const OF_FRAMEWORKS = /[^a-z0-9_]|^_|^on/;

/** What it is a specimen of, and what was wrong in what was said of it. */
export interface Said extends Restored {
	readonly model: PageModel;
}

export type Attributes = Iterable<{ readonly name: string; readonly value: string }>;

/**
 * Reads attributes as links are read: nothing is refused, what cannot be used is replaced, and a note says so. With a link, other
 * attributes change what that says.
 */
export async function readAttributes(attributes: Attributes): Promise<Said> {
	const said = Object.fromEntries([...attributes].map(({ name, value }) => [name, value]));
	const notes = new Notes();
	const link = said.link === undefined ? undefined : linkParts(said.link);
	const named = said.model ?? (link && modelInQuery(link.query));
	if (named !== undefined && !isModel(named))
		notes.add("model", `there is none called “${named}”`, "the default is used");
	const model = await modelNamed(named);
	const record: Record<string, string> = {};
	for (const [name, value] of Object.entries(said)) {
		if (!saysSpecimen(name) || STARTS.includes(name)) continue;
		if (isKnown(model, name)) record[name] = value;
		else notes.add(name, `no parameter of the ${model.noun} has that name`, "it is passed over");
	}
	const start = link && (await decodeLink(model, link.query, link.fragment));
	const read = restore(model, { model: model.name, ...record }, start?.specimen);
	return { model, specimen: read.specimen, notes: [...notes.all(), ...(start?.notes ?? []), ...read.notes] };
}

/** Whether an attribute of that name is about what grows. */
export function saysSpecimen(name: string): boolean {
	return !(OWN_ATTRIBUTES.some((own) => own === name) || OF_PAGES.has(name) || OF_FRAMEWORKS.test(name));
}
