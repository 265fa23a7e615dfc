/** Writes the list: run by add_links.mjs, and skipped by all else. */
import { expect, it } from "vitest";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { SPECIMEN_VERSION } from "../../../web/src/specimen/specimen";
import { FROZEN_VERSION, isFrozen, type Listed, meantBy, modelOf, readList, versionOf, writeList } from "./list";
import { standingLinks } from "./standing_links";

const asked: readonly string[] | undefined = process.env.PANICLE_ADD_LINKS && JSON.parse(process.env.PANICLE_ADD_LINKS);

it.skipIf(!asked)("lists links", { timeout: 600_000 }, async () => {
	const { frozen, previews } = readList();
	const given = (asked ?? []).filter((each) => each !== "--renew");
	const links = given.length > 0 ? given : await standing();
	const known = new Set([...frozen, ...previews].map(({ link }) => link));
	const again = asked?.includes("--renew") ? await Promise.all(previews.map(({ link }) => grown(link))) : undefined;
	const added = await Promise.all(links.filter((link) => !known.has(link)).map(grown));
	// What was a preview and is none any more is for ever from now on.
	const open = await Promise.all(
		[...(again ?? previews), ...added].map(async (each) => ({ each, fixed: await isFixed(each) })),
	);
	const fixed = open.flatMap((one) => (one.fixed ? one.each : []));
	writeList({ frozen: [...frozen, ...fixed], previews: open.flatMap((one) => (one.fixed ? [] : one.each)) });
	console.log(
		`${added.length} links added, ${fixed.length} of them for ever; ${again?.length ?? 0} previews taken anew`,
	);
});

async function standing(): Promise<string[]> {
	const models = await Promise.all(modelNames().map(modelNamed));
	return models.flatMap((model) => {
		const versions = model.preview ? [SPECIMEN_VERSION] : Array.from({ length: FROZEN_VERSION }, (_, i) => i + 1);
		return versions.flatMap((version) => standingLinks(model, version));
	});
}

async function grown(link: string): Promise<Listed> {
	const { notes, fingerprint } = await meantBy(link);
	expect([link, notes]).toEqual([link, []]);
	return { link, fingerprint };
}

async function isFixed({ link }: Listed): Promise<boolean> {
	return isFrozen(await modelOf(link), versionOf(link));
}
