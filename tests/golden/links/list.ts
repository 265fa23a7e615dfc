/** The list of links that were published, and what they grew into: docs/links.md, "For ever". */
import { readFileSync, writeFileSync } from "node:fs";
import { version } from "../../../package.json";
import type { Core } from "../../../web/src/core/core";
import { modelNamed } from "../../../web/src/models/index";
import type { Model } from "../../../web/src/models/model";
import { decodeLink, linkParts, modelInQuery } from "../../../web/src/specimen/link";
import { SPECIMEN_VERSION } from "../../../web/src/specimen/specimen";
import { freshCore } from "../../web/core/wasm";

export interface Listed {
	/** From its `?` on. */
	readonly link: string;
	readonly fingerprint: string;
}

export interface LinkList {
	/** Never changed, never taken out. */
	readonly frozen: readonly Listed[];
	/** Of models, and of a version, that may still change: made anew when they do. */
	readonly previews: readonly Listed[];
}

const FILE = new URL("links.json", import.meta.url);

/** The version that releases hold to: what a candidate brings is not among it. */
export const FROZEN_VERSION = version.includes("-") ? SPECIMEN_VERSION - 1 : SPECIMEN_VERSION;

/** Whether what a link of that model and version means is fixed. */
export const isFrozen = ({ preview }: Model, of: number): boolean => !preview && of <= FROZEN_VERSION;

export function readList(): LinkList {
	return JSON.parse(readFileSync(FILE, "utf8"));
}

export function writeList(list: LinkList): void {
	const lines = (links: readonly Listed[]) => links.map((each) => `\t\t${JSON.stringify(each)}`).join(",\n");
	const text = Object.entries(list).map(([key, links]) => `\t"${key}": [\n${lines(links)}\n\t]`);
	writeFileSync(FILE, `{\n${text.join(",\n")}\n}\n`);
}

export const modelOf = (link: string): Promise<Model> => modelNamed(modelInQuery(linkParts(link).query));

/** Links from before versions were written are version 1. */
export const versionOf = (link: string): number => Number(new URLSearchParams(linkParts(link).query).get("v") ?? 1);

export interface Meant {
	/** What could not be used. */
	readonly notes: readonly string[];
	readonly fingerprint: string;
}

const cores = new Map<string, Promise<Core>>();

/** What a link grows into, as the page does it. */
export async function meantBy(link: string): Promise<Meant> {
	const { query, fragment } = linkParts(link);
	const model = await modelOf(link);
	const { specimen, notes } = await decodeLink(model, query, fragment);
	await model.prepare?.(specimen);
	const core = cores.get(model.wasm) ?? freshCore(model.wasm);
	cores.set(model.wasm, core);
	const { fingerprint } = model.read(
		(await core).grow(model.encode(specimen, { meshes: false, measures: false })),
		specimen,
	);
	return { notes: notes.map(({ text }) => text), fingerprint };
}
