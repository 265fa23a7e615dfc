/**
 * Growing a plant's members: each a specimen of its own, by the core of its own model, in whatever order. What each is follows
 * from what is asked alone, so that any worker in any order gives the same, and each can be grown again by itself.
 */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import { CoreError } from "../core/errors";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { isModel, modelNamed, modelNames } from "./index";
import type { Member, MemberAsked, Place } from "./member";
import { Looks, levelsOf } from "./member_looks";
import type { GrowthOptions, Model } from "./model";

/** Has the core of that file (`growth.wasm`) grow a request. */
export type RunCore = (wasm: string, blocks: readonly Block[]) => Promise<Answer>;

export interface MembersOptions {
	/** Whether meshes are wanted; the default is yes. */
	meshes?: boolean;
	/** How many are under way at once; 1 where absent. */
	abreast?: number;
	/** Those that have grown before: what is asked as it was then is not grown anew. */
	kept?: KeptMembers;
	/** Told after some have grown, with what there is so far; where it throws, nothing more is grown. */
	grew?(grown: Plant, done: number, all: number): void;
}

/** Members by what was asked: those of the last plant, for the next one that has many of the same. */
export class KeptMembers {
	#known = new Map<string, Member>();

	/** Those that the plant asks for which are known; from now on no others are. */
	keep(asked: readonly MemberAsked[], meshes: boolean): (Member | undefined)[] {
		const keys = asked.map((each) => keyOf(each, meshes));
		const found = keys.map((key) => this.#known.get(key));
		this.#known = new Map(keys.flatMap((key, i) => (found[i] ? [[key, found[i]] as const] : [])));
		return found;
	}

	add(asked: MemberAsked, meshes: boolean, member: Member): void {
		this.#known.set(keyOf(asked, meshes), member);
	}
}

function keyOf({ model, preset, seed, values, surroundings }: MemberAsked, meshes: boolean): string {
	return JSON.stringify([model, preset, seed, values, [...(surroundings ?? [])], meshes]);
}

/** What is told in between is told when so many more have grown, as a share of those there are. */
const STEP = 1;

/**
 * A plant with its members grown.
 * @throws CoreError where the text asks for a model, a preset or a parameter that does not exist, at its place, and what `run` throws
 */
export async function grownMembers(
	model: Model,
	grown: Plant,
	run: RunCore,
	{ meshes = true, abreast = 1, kept, grew }: MembersOptions = {},
): Promise<Plant> {
	const { members } = model;
	if (!members) return grown;
	const asked = members.asked(grown);
	const notes = new Set<string>();
	const read = await resolved(model, asked, notes);
	const looks = new Looks();
	const done: (Member | undefined)[] = kept?.keep(asked, meshes) ?? asked.map(() => undefined);
	const noted = { ...grown, notes: [...grown.notes, ...notes] };
	let count = done.filter(Boolean).length;
	let tell = Math.max(16, count + 1);
	let next = 0;
	let failed = false;
	const work = async () => {
		while (next < asked.length && !failed) {
			const at = next++;
			if (done[at]) continue;
			const member = await memberOf(read[at], asked[at], run, meshes, looks);
			done[at] = member;
			kept?.add(asked[at], meshes, member);
			if (++count < tell || count === asked.length) continue;
			tell = Math.ceil(count * (1 + STEP));
			grew?.(members.joined(noted, [...done]), count, asked.length);
		}
	};
	const works = Array.from({ length: Math.max(1, abreast) }, () =>
		work().catch((error: unknown) => {
			failed = true;
			throw error;
		}),
	);
	await Promise.all(works);
	return members.joined(noted, done);
}

interface Read {
	readonly model: Model;
	readonly specimen: Specimen;
}

/** What is asked as specimens, with what each needs fetched. */
async function resolved(of: Model, asked: readonly MemberAsked[], notes: Set<string>): Promise<Read[]> {
	const models = new Map<string, Model>();
	const read: Read[] = [];
	for (const each of asked) {
		const model = models.get(each.model) ?? (await known(of, each));
		models.set(each.model, model);
		checked(model, each);
		const { values, seed, preset } = each;
		const restored = restore(model, { model: model.name, preset, seed, ...whole(model, values) });
		for (const { text } of restored.notes) notes.add(`${each.model}/${preset}: ${text}`);
		await model.prepare?.(restored.specimen)?.catch(() => {});
		read.push({ model, specimen: restored.specimen });
	}
	return read;
}

/** What is drawn is any number; of what is counted, the nearest whole one. */
function whole({ table }: Model, values: MemberAsked["values"]): MemberAsked["values"] {
	const counted = (key: string) => table.entry(key)?.kind === "integer";
	return Object.fromEntries(
		Object.entries(values).map(([key, value]) => [
			key,
			typeof value === "number" && counted(key) ? Math.round(value) : value,
		]),
	);
}

async function known(of: Model, { model: name, place }: MemberAsked): Promise<Model> {
	const others = modelNames().filter((each) => each !== of.name);
	if (isModel(name) && name !== of.name) return modelNamed(name);
	const why = name === of.name ? `A ${of.noun} stands in no ${of.noun}` : `There is no model ${name}`;
	throw wrong(`${why}; there are ${others.join(", ")}.`, place);
}

function checked({ presets, table, noun }: Model, { preset, values, place, places }: MemberAsked): void {
	if (!presets.named(preset))
		throw wrong(
			`There is no ${noun} called ${preset}; there are ${presets.list.map(({ name }) => name).join(", ")}.`,
			place,
		);
	for (const key of Object.keys(values)) {
		if (table.entry(key)) continue;
		const keys = table.entries.map((each) => each.key).join(", ");
		throw wrong(`The ${noun} has no parameter ${key}; there are ${keys}.`, places[key] ?? place);
	}
}

function wrong(message: string, { line, column }: Place): CoreError {
	return new CoreError("undefined name", message, line, column);
}

async function memberOf(
	{ model, specimen }: Read,
	{ surroundings }: MemberAsked,
	run: RunCore,
	meshes: boolean,
	looks: Looks,
): Promise<Member> {
	const levels = meshes && model.levels !== undefined;
	const options: GrowthOptions = {
		meshes: meshes && !levels,
		measures: false,
		...(levels ? { levels } : {}),
		...(surroundings && model.surroundings ? { surroundings } : {}),
	};
	const plant = model.read(await run(model.wasm, model.encode(specimen, options)), specimen);
	const { fingerprint } = plant;
	const link = await encodeLink(model, specimen);
	return { specimen, link, fingerprint, ...(await levelsOf(model, plant, specimen, meshes, looks)) };
}
