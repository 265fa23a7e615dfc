/** Links that between them use all of a model: each preset, each key by itself, and each detail that only links and files have. */
import type { Model } from "../../../web/src/models/model";
import { nearestWithin, type ParameterEntry } from "../../../web/src/specimen/table";

/** A parameter that keeps plants small; few particles suffice to test a link's meaning. */
const SMALL: Readonly<Record<string, string>> = { leaf: "n=120", tree: "n=80", root: "n=60", stand: "many=24" };

/** Details, by model and the version since which links have them. */
const DETAILS: Readonly<Record<string, readonly { since: number; link: string }[]>> = {
	bunch: [
		{ since: 1, link: "m=3&n=1,2" },
		{ since: 1, link: "m=12&n=4,5,6,7,8,7,6,5,4,3,2" },
		{ since: 1, link: "#g=S6zIzM-1UnDTMNSM1nbTMNKM5QIA" },
		{ since: 2, link: "preset=riesling&thin=0.1.a" },
	],
	leaf: [],
	grammar: [
		{ since: 2, link: "steps=3" },
		{ since: 2, link: "preset=plant-a&steps=4&define=none:1" },
		{ since: 2, link: "define=angle:20,golden:90.5" },
		{
			since: 2,
			link: "define=a:25&#g=U05JTcvMS1VIVDA24EpJLcosSyzJzM9TyEnNSy_JsFIw4UqsyMzPtVKI4IpQ0NW1U3BTiFbQ1kjUVIhQiFWIVtCFMd0U6nJSE9M0DPRMNbncoErduAA",
		},
	],
	tree: [{ since: 1, link: "shape=spline&profile=0.2,0,1,0.4,0.5,0.8,0,1" }],
	root: [{ since: 1, link: "shape=spline&profile=0.1,0,1,0.5,0.4,1" }],
};

/** Links of one preset each. */
export function presetLinks(model: Model, version: number): string[] {
	const presets = model.presets.list.filter(({ since = 1 }) => since <= version);
	return presets.map(({ name }, i) => linkOf(model, version, [`preset=${name}`, `seed=${i + 1}`]));
}

/** @param version the links' `v` */
export function coveringLinks(model: Model, version: number): string[] {
	const keys = [...model.table.links].filter(
		([key, entries]) => entries.every(({ since }) => since <= version) && !SMALL[model.name]?.startsWith(`${key}=`),
	);
	const details = (DETAILS[model.name] ?? []).filter(({ since }) => since <= version);
	return [
		...presetLinks(model, version),
		...valuesOf(keys).map((parts) => linkOf(model, version, parts)),
		...details.map(({ link }) => linkOf(model, version, [link])),
	];
}

function linkOf(model: Model, version: number, parts: readonly string[]): string {
	const start = model.unnamed ? [] : [`model=${model.name}`];
	const small = SMALL[model.name] ? [SMALL[model.name]] : [];
	return fragmentLast(`?v=${version}&${[...start, ...parts, ...small].join("&")}`);
}

/** How many numbers and colours share a link. */
const FEW = 4;

/** Each option of a choice in a link of its own; numbers a third of the way up their range, and colours, a few together. */
function valuesOf(keys: readonly [key: string, entries: readonly ParameterEntry[]][]): string[][] {
	const choices: string[][] = [];
	const others: string[] = [];
	for (const [key, entries] of keys) {
		const [first] = entries;
		// A mesh out of a file is too long for a link.
		if (first.kind === "choice")
			choices.push(...first.options.flatMap((option) => (option === "mesh" ? [] : [[`${key}=${option}`]])));
		else others.push(`${key}=${entries.map(valueFor).join(",")}`);
	}
	const links = Array.from({ length: Math.ceil(others.length / FEW) }, (_, i) => others.slice(FEW * i, FEW * (i + 1)));
	return [...choices, ...links];
}

function valueFor(entry: ParameterEntry): string {
	if (entry.kind === "colour") return "a9b04e";
	return entry.kind === "choice"
		? entry.options[0]
		: String(nearestWithin(entry, entry.min + (entry.max - entry.min) / 3));
}

/** Moves the fragment of a detail behind the whole query. */
function fragmentLast(link: string): string {
	const [, before, fragment, after] = /^([^#]*?)&?(#[^&]*)(.*)$/.exec(link) ?? [];
	return fragment === undefined ? link : `${before}${after}${fragment}`;
}
