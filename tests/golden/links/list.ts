/** The frozen links with their fingerprints (links.json), and the links of previews: docs/links.md. */
import { readFileSync, writeFileSync } from "node:fs";
import { version } from "../../../package.json";
import type { Core } from "../../../web/src/core/core";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import type { Model } from "../../../web/src/models/model";
import { decodeLink, linkParts, modelInQuery } from "../../../web/src/specimen/link";
import { SPECIMEN_VERSION } from "../../../web/src/specimen/specimen";
import { freshCore } from "../../web/core/wasm";
import { coveringLinks } from "./covering_links";

export interface FrozenLink {
	/** The link's query, from its `?` on, and its fragment. */
	readonly link: string;
	readonly fingerprint: string;
}

const FILE = new URL("links.json", import.meta.url);

/** The newest version of links that is frozen: a release candidate's own version is not. */
export const FROZEN_VERSION = version.includes("-") ? SPECIMEN_VERSION - 1 : SPECIMEN_VERSION;

/** Whether the meaning of a model's links of that version is frozen. */
export const isFrozen = ({ preview }: Model, of: number): boolean => !preview && of <= FROZEN_VERSION;

export const readFrozenLinks = (): readonly FrozenLink[] => JSON.parse(readFileSync(FILE, "utf8")).frozen;

export function writeFrozenLinks(links: readonly FrozenLink[]): void {
	const lines = links.map((each) => `\t\t${JSON.stringify(each)}`);
	writeFileSync(FILE, `{\n\t"frozen": [\n${lines.join(",\n")}\n\t]\n}\n`);
}

const allModels = () => Promise.all(modelNames().map(modelNamed));

/** Links that use everything of the models and versions that are frozen: all of them have to be in links.json. */
export async function linksToFreeze(): Promise<string[]> {
	const versions = Array.from({ length: FROZEN_VERSION }, (_, i) => i + 1);
	const models = (await allModels()).filter(({ preview }) => !preview);
	return models.flatMap((model) => versions.flatMap((of) => coveringLinks(model, of)));
}

/** Links that use everything of the models that are previews. */
export async function previewLinks(): Promise<string[]> {
	const models = (await allModels()).filter(({ preview }) => preview);
	return models.flatMap((model) => coveringLinks(model, SPECIMEN_VERSION));
}

export const modelOf = (link: string): Promise<Model> => modelNamed(modelInQuery(linkParts(link).query));

/** Links from before versions were written are version 1. */
export const versionOf = (link: string): number => Number(new URLSearchParams(linkParts(link).query).get("v") ?? 1);

export interface Meant {
	/** The notes about the parts of the link that could not be used. */
	readonly notes: readonly string[];
	readonly fingerprint: string;
}

const cores = new Map<string, Promise<Core>>();

/** Grows a link's plant, as the page does. */
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
