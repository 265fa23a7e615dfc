/** Links that are to stand in the list: of each model and version all presets, each key by itself, and what only details hold. */
import type { Model } from "../../../web/src/models/model";
import { type Entry, nearestWithin } from "../../../web/src/specimen/table";

/** Few particles do: what links mean shows in them as well. */
const SMALL: Readonly<Record<string, string>> = { leaf: "n=120", tree: "n=80", root: "n=60", stand: "many=24" };

/** Details, by model and the version from which they hold. */
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

/** @param version what `v` says */
export function standingLinks(model: Model, version: number): string[] {
	const start = model.unnamed ? [] : [`model=${model.name}`];
	const small = SMALL[model.name] ? [SMALL[model.name]] : [];
	const link = (...parts: string[]) => `?v=${version}&${[...start, ...parts].join("&")}`;
	const presets = model.presets.list.filter(({ since = 1 }) => since <= version);
	const keys = [...model.table.links].filter(
		([key, entries]) =>
			entries.every(({ since }) => since <= version) && !small.some((part) => part.startsWith(`${key}=`)),
	);
	return [
		...presets.map(({ name }, i) => link(`preset=${name}`, `seed=${i + 1}`, ...small)),
		...together(keys).map((parts) => link(...parts, ...small)),
		...(DETAILS[model.name] ?? []).filter(({ since }) => since <= version).map((detail) => link(detail.link, ...small)),
	].map(fragmentLast);
}

/** How many numbers a link has besides. */
const FEW = 4;

/** Each option of a choice in a link of its own; numbers a third of the way up, and colours, a few at once. */
function together(keys: readonly [key: string, entries: readonly Entry[]][]): string[][] {
	const choices: string[][] = [];
	const others: string[] = [];
	for (const [key, entries] of keys) {
		const [first] = entries;
		// A mesh of one's own is too long for a link.
		if (first.kind === "choice")
			choices.push(...first.options.flatMap((option) => (option === "mesh" ? [] : [[`${key}=${option}`]])));
		else others.push(`${key}=${entries.map(middling).join(",")}`);
	}
	const links = Array.from({ length: Math.ceil(others.length / FEW) }, (_, i) => others.slice(FEW * i, FEW * (i + 1)));
	return [...choices, ...links];
}

function middling(entry: Entry): string {
	if (entry.kind === "colour") return "a9b04e";
	return entry.kind === "choice"
		? entry.options[0]
		: String(nearestWithin(entry, entry.min + (entry.max - entry.min) / 3));
}

/** What a detail says in the fragment stands behind all that is in the query. */
function fragmentLast(link: string): string {
	const [, before, fragment, after] = /^([^#]*?)&?(#[^&]*)(.*)$/.exec(link) ?? [];
	return fragment === undefined ? link : `${before}${after}${fragment}`;
}
