/**
 * Any string is a safe link, of any model: random strings, and published links with a change in them. `npm run fuzz -- links [100000]` tries
 * more of them.
 */
import fc from "fast-check";
import { expect, it } from "vitest";
import { readAttributes } from "../../web/src/element/attributes";
import { modelNamed, modelNames } from "../../web/src/models/index";
import { decodeLink, encodeLink, linkParts, modelInQuery } from "../../web/src/specimen/link";
import { previewLinks, readFrozenLinks } from "../golden/links/list";

const RUNS = Number(process.env.PANICLE_FUZZ ?? 200);

const models = await Promise.all(modelNames().map(modelNamed));
const published = [...readFrozenLinks().map(({ link }) => link), ...(await previewLinks())];

/** Names that objects have of their own accord. */
const INHERITED = [
	"__proto__",
	"constructor",
	"prototype",
	"toString",
	"hasOwnProperty",
	"valueOf",
	"__defineGetter__",
	"then",
];
const KEYS = [
	...INHERITED,
	...new Set([
		...["v", "model", "preset", "seed", "g", "parameters", "look", "inputs"],
		...models.flatMap(({ table, details }) => [...table.links.keys(), ...details.flatMap(({ keys }) => keys)]),
	]),
];
const VALUES = [
	...[
		"",
		"0",
		"-0",
		"1",
		"-1",
		"1e308",
		"1e-308",
		"NaN",
		"Infinity",
		"0x10",
		"９",
		"1,2",
		",",
		"1,,2",
		"%",
		"%00",
		"%E0%A4",
		"+",
		"true",
		"null",
	],
	...[
		"[object Object]",
		'{"__proto__":{"polluted":1}}',
		"ffffff",
		"duku",
		"oak",
		"natural",
		"spline",
		"a.1z.hra0hr",
		...INHERITED,
		...modelNames(),
	],
];

const noise = fc.string({ unit: "binary", maxLength: 120 });
const pair = fc
	.tuple(fc.oneof(fc.constantFrom(...KEYS), noise), fc.oneof(fc.constantFrom(...VALUES), noise))
	.map(([key, value]) => `${key}=${value}`);
const model = fc.oneof(
	fc.constant(""),
	fc.constantFrom(...modelNames(), ...INHERITED).map((name) => `model=${name}&`),
);
const query = fc.tuple(model, fc.array(pair, { maxLength: 24 })).map(([named, parts]) => `?${named}${parts.join("&")}`);
const base64 = fc.stringMatching(/^[A-Za-z0-9_-]{0,200}$/);
const fragment = fc.oneof(
	fc.constant(""),
	noise.map((text) => `#${text}`),
	fc.tuple(fc.constantFrom("g", "o", ...INHERITED), base64).map(([key, text]) => `#${key}=${text}`),
);

/** A published link with some of it cut out, put twice, put elsewhere, or overwritten. */
const mutated = fc
	.tuple(
		fc.constantFrom(...published),
		fc.array(
			fc.tuple(fc.constantFrom("cut", "twice", "over", "pair"), fc.nat(200), fc.nat(30), fc.oneof(noise, pair)),
			{ minLength: 1, maxLength: 4 },
		),
	)
	.map(([link, changes]) =>
		changes.reduce((text, [kind, from, length, other]) => {
			const at = from % (text.length + 1);
			const [before, middle, after] = [text.slice(0, at), text.slice(at, at + length), text.slice(at + length)];
			if (kind === "cut") return before + after;
			if (kind === "twice") return before + middle + middle + after;
			if (kind === "over") return before + other.slice(0, length) + after;
			return `${text.split("#")[0]}&${other}${text.includes("#") ? text.slice(text.indexOf("#")) : ""}`;
		}, link),
	);

const anyString = fc.oneof(
	noise,
	fc.tuple(query, fragment).map((parts) => parts.join("")),
	{ arbitrary: mutated, weight: 2 },
);

const prototypes = [Object, Array, String, Number, Function, Map, Set, Promise].map((each) => each.prototype);
const inherited = () => prototypes.map((each) => Reflect.ownKeys(each).length);

/** Whether a value is data all through: objects, lists and typed arrays with no prototypes but their own. */
function isPlain(value: unknown): boolean {
	if (typeof value !== "object" || value === null) return typeof value !== "function";
	if (ArrayBuffer.isView(value)) return true;
	const prototype = Object.getPrototypeOf(value);
	return (prototype === Object.prototype || prototype === Array.prototype) && Object.values(value).every(isPlain);
}

it(`${RUNS} strings are safe links`, { timeout: 3_600_000 }, async () => {
	const before = inherited();
	await fc.assert(
		fc.asyncProperty(anyString, async (text) => {
			const { query: search, fragment: hash } = linkParts(text);
			const of = await modelNamed(modelInQuery(search));
			const { specimen, notes } = await decodeLink(of, search, hash);
			expect(isPlain(specimen)).toBe(true);
			for (const { text: note } of notes) expect(note).toMatch(/^[^\n]{1,400}$/);
			// The specimen is valid: its own link restores it without a note.
			const link = linkParts(await encodeLink(of, specimen));
			const { notes: again, specimen: same } = await decodeLink(of, link.query, link.fragment);
			expect(same).toEqual(specimen);
			expect(again).toEqual([]);
			// As an element's attribute it is the same link.
			expect((await readAttributes([{ name: "link", value: text }])).specimen).toEqual(specimen);
		}),
		{ numRuns: RUNS },
	);
	expect(inherited()).toEqual(before);
	expect("polluted" in {}).toBe(false);
});
