/**
 * Grows a plant's members: each a specimen of its own, by the core of its own model. A member depends on its request
 * alone, so that workers may grow members in any order, and each can be grown again by itself.
 */
import type { Block } from "../core/container";
import type { Answer } from "../core/core";
import { CoreError } from "../core/errors";
import type { Message } from "../locale/texts";
import { isModel, modelNamed, modelNames } from "../models/index";
import type { Member, MemberRequest, TextPosition } from "../models/member";
import type { GrowthOptions, Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { fromPreset } from "../specimen/from_preset";
import { encodeLink } from "../specimen/link";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { levelsOf, SharedMaterials } from "./member_looks";
import { spotsOf } from "./member_spots";
import { text } from "./messages.generated";
import { isOnLine, readable, readablePlant } from "./readable";

/** Runs a request in the core of a file (`growth.wasm`). */
export type RunCore = (wasm: string, blocks: readonly Block[]) => Promise<Answer>;

export interface MembersOptions {
	/** Whether to make meshes; the default is true. */
	meshes?: boolean;
	/** The most members that grow at once; 1 where absent. */
	concurrency?: number;
	/** Members that have grown before; equal requests reuse them. */
	cache?: MemberCache;
	/** The most bytes of all their meshes; the default is the limit of a page. */
	most?: number;
	/** Whether the time limit is over: members that have not begun are left out, and the plant is cut short. */
	timeIsOver?: () => boolean;
	/** Called with the plant so far after some members have grown; if it throws, growing stops. */
	grew?(grown: Plant, done: number, all: number): void;
}

/** Members of the last plant by request, for a next plant with many of the same. */
export class MemberCache {
	/**
	 * Looks of all members, so that new ones share materials with cached ones; files do not depend on the order of
	 * growing.
	 */
	readonly materials = new SharedMaterials();
	#known = new Map<string, Member>();

	/** Returns the cached members of these requests, and drops all others. */
	retain(requests: readonly MemberRequest[], meshes: boolean): (Member | undefined)[] {
		const keys = requests.map((each) => keyOf(each, meshes));
		const found = keys.map((key) => this.#known.get(key));
		this.#known = new Map(keys.flatMap((key, i) => (found[i] ? [[key, found[i]] as const] : [])));
		return found;
	}

	/** Caches a grown member. */
	add(request: MemberRequest, meshes: boolean, member: Member): void {
		this.#known.set(keyOf(request, meshes), member);
	}
}

/** Returns the cache key of a request: equal for requests that grow equal members. */
function keyOf({ model, preset, seed, values, surroundings, spots }: MemberRequest, meshes: boolean): string {
	return JSON.stringify([model, preset, seed, values, surroundings, spots, meshes]);
}

/** Report progress when the number of members has grown by this share. */
const STEP = 1;
/** The most bytes of meshes: a page holds them twice, once for the graphics card. */
const MAX_BYTES = 600e6;

/**
 * Grows the members of a plant.
 * @throws CoreError at the position of a request in the plant's text: where a model, a preset or a parameter does not
 * exist, where a member cannot be grown, and where all of them take too much memory; and errors of `run`
 */
export async function grownMembers(
	model: Model,
	grown: Plant,
	run: RunCore,
	{ meshes = true, concurrency = 1, cache, most = MAX_BYTES, timeIsOver = () => false, grew }: MembersOptions = {},
): Promise<Plant> {
	const { members } = model;
	if (!members) return grown;
	const requests = members.requests(grown);
	const notes = new Set<string>();
	const read = await resolveRequests(model, requests, notes);
	const usedRequests = read.map(({ request: each }) => each);
	const looks = cache?.materials ?? new SharedMaterials();
	const order = growingOrder(requests);
	const done: (Member | undefined)[] = cache?.retain(usedRequests, meshes) ?? requests.map(() => undefined);
	const joined = () => members.joined({ ...grown, notes: [...grown.notes, ...notes, ...notesOf(done)] }, [...done]);
	let count = done.filter(Boolean).length;
	let bytes = done.reduce((sum, member) => sum + (member ? bytesOf(member) : 0), 0);
	let nextReport = Math.max(16, count + 1);
	let next = 0;
	let failed = false;
	/**
	 * Grows members, the next free one in `order`, until none is left; `concurrency` of these loops run at the same time.
	 * Progress is reported each time the number of members has doubled.
	 */
	const work = async () => {
		while (next < requests.length && !failed) {
			const at = order[next++];
			if (done[at]) continue;
			if (timeIsOver()) return;
			const member = await memberOf(read[at], run, meshes, looks);
			bytes += bytesOf(member);
			if (bytes > most) throw tooMuch(requests[at], most);
			done[at] = member;
			// Cache no member whose resources could not be fetched: the next try may succeed.
			if (read[at].prepared) cache?.add(usedRequests[at], meshes, member);
			if (++count < nextReport || count === requests.length) continue;
			nextReport = Math.ceil(count * (1 + STEP));
			grew?.(joined(), count, requests.length);
		}
	};
	const works = Array.from({ length: Math.max(1, concurrency) }, () =>
		work().catch((error: unknown) => {
			failed = true;
			throw error;
		}),
	);
	await Promise.all(works);
	const cuts = new Set(done.map((member) => member?.cutShort));
	if (count < requests.length) {
		notes.add(text("members_time", { count, total: requests.length }));
		cuts.add("time");
	}
	const cutShort = cuts.has("time") ? "time" : cuts.has("limit") ? "limit" : grown.cutShort;
	return cutShort ? { ...joined(), cutShort } : joined();
}

/**
 * Returns the order of growing: members of one preset one after the other, because cores cache results for the next
 * plant.
 */
function growingOrder(requests: readonly MemberRequest[]): readonly number[] {
	const presets = new Map<string, number[]>();
	for (const [i, { model, preset }] of requests.entries()) {
		const key = `${model}/${preset}`;
		const those = presets.get(key) ?? [];
		presets.set(key, those);
		those.push(i);
	}
	return [...presets.values()].flat();
}

/** Returns the notes of the members, each once, in the order of requests. */
function notesOf(members: readonly (Member | undefined)[]): Set<string> {
	return new Set(
		members.flatMap((member) => {
			const { model, preset } = member?.specimen ?? {};
			const reported = member?.notes ?? [];
			return reported.map((note) => text("member_note", { preset: `${model}/${preset}`, note }));
		}),
	);
}

/** Returns the bytes of a member's meshes. */
function bytesOf({ levels }: Member): number {
	let bytes = 0;
	for (const { mesh } of levels.flat())
		for (const each of Object.values(mesh)) if (ArrayBuffer.isView(each)) bytes += each.byteLength;
	return bytes;
}

/** Returns the error, at a request's position, of members whose meshes need too much memory. */
function tooMuch({ place }: MemberRequest, most: number): CoreError {
	const message = text.message("members_too_large", { megabytes: most / 1e6 });
	return new CoreError("limit", message, place.line, place.column);
}

interface PreparedMember {
	/** The request without values that the model ignores. */
	readonly request: MemberRequest;
	readonly model: Model;
	readonly specimen: Specimen;
	/** Whether all resources besides the core are there. */
	readonly prepared: boolean;
}

/**
 * Turns requests into specimens, and fetches the resources of each.
 * @param of model of the whole plant, which may not be a member of itself
 * @param notes receives notes on values that do not fit
 * @throws CoreError at the position of a wrong name
 */
async function resolveRequests(
	of: Model,
	requests: readonly MemberRequest[],
	notes: Set<string>,
): Promise<PreparedMember[]> {
	const models = new Map<string, Model>();
	const read: Omit<PreparedMember, "prepared">[] = [];
	// Whether resources could be fetched, by the values that determine them.
	const fetched = new Map<string, Promise<boolean>>();
	const keys: string[] = [];
	for (const request of requests) {
		const model = models.get(request.model) ?? (await requestedModel(of, request));
		models.set(request.model, model);
		const each = withoutUnused(model, request);
		checkNames(model, each);
		const { values, seed, preset, surroundings } = each;
		// Values for names in the member's text, besides its parameters.
		const own = ownNames(model, each);
		const restored = restore(model, {
			...{ model: model.name, preset, seed, surroundings },
			...roundedValues(model, values),
			...(own ? ownNamesField(model)?.named?.(fromPreset(model, preset), own) : {}),
		});
		const named = `${each.model}/${preset}`;
		for (const note of restored.notes) notes.add(text("member_note", { preset: named, note: note.text }));
		const { specimen } = restored;
		read.push({ request: each, model, specimen });
		const key = preparedBy(each);
		keys.push(key);
		if (fetched.has(key)) continue;
		if (own) await checkOwnNames(model, specimen, each);
		const failed = (error: unknown) => {
			const problem = error instanceof Error ? error.message : String(error);
			notes.add(text("member_note", { preset: named, note: text("member_not_loaded", { problem }) }));
			return false;
		};
		fetched.set(
			key,
			Promise.resolve(model.prepare?.(specimen)).then(() => true, failed),
		);
	}
	const prepared = new Map<string, boolean>();
	for (const [key, came] of fetched) prepared.set(key, await came);
	return read.map((each, i) => ({ ...each, prepared: prepared.get(keys[i]) ?? true }));
}

/** Drops surroundings where the model has no such field. */
function withoutUnused({ details }: Model, { surroundings, ...request }: MemberRequest): MemberRequest {
	const isActive = surroundings !== undefined && details.some(({ keys }) => keys.includes("surroundings"));
	return isActive ? { ...request, surroundings } : request;
}

/**
 * Returns a key of the values that determine which resources are needed: choices, and whether numbers are above 0.
 */
function preparedBy({ model, preset, values }: MemberRequest): string {
	const relevant = Object.entries(values).map(([key, value]) => [key, typeof value === "number" ? value > 0 : value]);
	return JSON.stringify([model, preset, relevant]);
}

/** Returns the field that reads a text's own names. */
const ownNamesField = ({ details }: Model) => details.find(({ named }) => named);

/** Returns the values of the text's own names; undefined where all names are in the table. */
function ownNames({ table }: Model, { values }: MemberRequest): Record<string, string> | undefined {
	const own = Object.entries(values).filter(([key]) => !table.entry(key));
	return own.length > 0 ? Object.fromEntries(own.map(([key, value]) => [key, String(value)])) : undefined;
}

/**
 * Checks the names in a request that may be defined by the member's text.
 * @throws CoreError at the position of a name that neither the table nor the text has
 */
async function checkOwnNames(
	model: Model,
	specimen: Specimen,
	{ place, places, preset }: MemberRequest,
): Promise<void> {
	const stranger = await ownNamesField(model)?.unknownName?.(specimen);
	if (!stranger) return;
	const { name, problem } = stranger;
	const parameters = model.table.entries.map(({ key }) => key).join(", ");
	const names = { model: model.name, parameter: name, parameters, preset, problem: problem.text };
	throw undefinedName(text.message("member_unknown_name", names), places[name] ?? place);
}

/** Rounds values of integer parameters; drops values that are no parameters. */
function roundedValues({ table }: Model, values: MemberRequest["values"]): MemberRequest["values"] {
	const counted = (key: string) => table.entry(key)?.kind === "integer";
	return Object.fromEntries(
		Object.entries(values)
			.filter(([key]) => table.entry(key))
			.map(([key, value]) => [key, typeof value === "number" && counted(key) ? Math.round(value) : value]),
	);
}

/**
 * Returns the model that a request names.
 * @param of model of the whole plant
 * @throws CoreError at the request's position where there is no such model, or it is the plant's own
 */
async function requestedModel(of: Model, { model: name, place }: MemberRequest): Promise<Model> {
	const others = modelNames().filter((each) => each !== of.name);
	if (isModel(name) && name !== of.name) return modelNamed(name);
	const key = name === of.name ? "member_of_itself" : "member_unknown_model";
	throw undefinedName(text.message(key, { model: name, models: others.join(", ") }), place);
}

/**
 * Checks that the preset and all parameters of a request exist.
 * @throws CoreError at their place in the plant's text
 */
function checkNames(model: Model, { preset, values, place, places }: MemberRequest): void {
	const { presets, table } = model;
	if (!presets.named(preset)) {
		const known = presets.list.map(({ name }) => name).join(", ");
		throw undefinedName(text.message("member_unknown_preset", { model: model.name, preset, presets: known }), place);
	}
	for (const key of Object.keys(values)) {
		// Whether the text has such a name of its own is known once it is fetched.
		if (table.entry(key) || (ownNamesField(model) && typeof values[key] === "number")) continue;
		const parameters = table.entries.map((each) => each.key).join(", ");
		const names = { model: model.name, parameter: key, parameters };
		throw undefinedName(text.message("member_unknown_parameter", names), places[key] ?? place);
	}
}

/** Returns the error of an undefined name at a position of the plant's text. */
function undefinedName(message: Message, { line, column }: TextPosition): CoreError {
	return new CoreError("undefined name", message, line, column);
}

/**
 * Grows a member. Errors are reported at the line that requests the member, because a position in the member's own text
 * means nothing to readers of the plant's text.
 * @throws CoreError
 */
async function memberOf(
	prepared: PreparedMember,
	run: RunCore,
	meshes: boolean,
	looks: SharedMaterials,
): Promise<Member> {
	try {
		return await grownMember(prepared, run, meshes, looks);
	} catch (error) {
		if (!(error instanceof CoreError)) throw error;
		const { model, preset, place } = prepared.request;
		const { reason, code, args } = error;
		const note = text("member_note", { preset: `${model}/${preset}`, note: error.message });
		throw new CoreError(reason, { code, args, text: note }, place.line, place.column);
	}
}

/**
 * Grows a member in its levels of detail if the model has them, else in full.
 * @param meshes whether its meshes are needed
 * @param looks materials that equal members share
 */
async function grownMember(
	read: PreparedMember,
	run: RunCore,
	meshes: boolean,
	looks: SharedMaterials,
): Promise<Member> {
	const { model, specimen, request } = read;
	const levels = meshes && model.levels !== undefined;
	const options: GrowthOptions = {
		meshes: meshes && !levels,
		measures: false,
		map: false,
		...(levels ? { levels } : {}),
	};
	const plant = model.read(await readable(run)(model.wasm, model.encode(specimen, options)), specimen);
	const { fingerprint, cutShort } = plant;
	// Notes on a line of a preset's own text are for the preset's own page.
	const { notes } = await readablePlant({ ...plant, notes: plant.notes.filter((note) => !isOnLine(note)) });
	const link = await encodeLink(model, specimen);
	const title = model.presets.named(specimen.preset)?.title ?? model.title;
	return {
		...{ specimen, title, link, fingerprint, notes },
		...(cutShort ? { cutShort } : {}),
		...spotsOf(plant, request),
		...(await levelsOf(model, plant, specimen, meshes, looks)),
	};
}
