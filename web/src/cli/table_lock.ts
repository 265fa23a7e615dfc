/**
 * The lock of a series' table, a file beside it: one process at a time writes a table. A lock whose process has ended, or has given no sign of
 * life for five minutes, holds nobody up.
 */
import { randomUUID } from "node:crypto";
import type { Surroundings } from "./surroundings";
import { UsageError } from "./usage";
import { writing } from "./writing";

/** Whose lock it is, as its file says. */
interface Owner {
	readonly host: string;
	readonly process: number;
	/** Tells this lock from every other. */
	readonly token: string;
	/** The last sign of life, in milliseconds since 1970. */
	readonly at: number;
}

/** Milliseconds without a sign of life after which a process counts as ended, wherever it runs. */
const SILENCE = 5 * 60_000;
/** Milliseconds between signs of life, at the least. */
const SIGN = 20_000;
/** A lock that has just been given up may be taken by another at once. */
const TRIES = 3;

type World = Pick<
	Surroundings,
	"readFile" | "createFile" | "replaceFile" | "removeFile" | "host" | "process" | "isRunning" | "now"
>;

export class TableLock {
	readonly #path: string;
	readonly #world: World;
	#owner: Owner;

	private constructor(path: string, owner: Owner, world: World) {
		this.#path = path;
		this.#owner = owner;
		this.#world = world;
	}

	/**
	 * @param table the path of the table
	 * @throws UsageError where another process writes it
	 */
	static async take(table: string, world: World): Promise<TableLock> {
		const path = `${table}.lock`;
		const owner = { host: world.host, process: world.process, token: randomUUID(), at: world.now() };
		for (let tries = 0; tries < TRIES; tries++) {
			if (await writing(path, () => world.createFile(path, JSON.stringify(owner))))
				return new TableLock(path, owner, world);
			const other = await read(path, world);
			if (other && holds(other, world)) {
				const seconds = Math.max(0, Math.round((world.now() - other.at) / 1000));
				throw new UsageError(
					`--out ${table}: process ${other.process} on ${other.host} writes it (${seconds} s ago); wait until it has ended`,
				);
			}
			await world.removeFile(path);
		}
		throw new UsageError(`--out ${table}: another process writes it; wait until it has ended`);
	}

	/**
	 * Gives a sign of life. To be called before every write.
	 * @throws Error where another process has taken the lock, since this one was silent for too long
	 */
	async keep(): Promise<void> {
		const there = await read(this.#path, this.#world);
		if (there?.token !== this.#owner.token)
			throw new Error(`${this.#path} was taken by another process; this one stops`);
		if (this.#world.now() - this.#owner.at < SIGN) return;
		this.#owner = { ...this.#owner, at: this.#world.now() };
		await writing(this.#path, () => this.#world.replaceFile(this.#path, JSON.stringify(this.#owner)));
	}

	/** Leaves the table to others; a lock that another process has taken stays. */
	async release(): Promise<void> {
		const there = await read(this.#path, this.#world);
		if (there?.token === this.#owner.token) await this.#world.removeFile(this.#path);
	}
}

/** Undefined where there is none, or none that can be read: whoever wrote half of it has ended. */
async function read(path: string, world: World): Promise<Owner | undefined> {
	const bytes = await world.readFile(path).catch(() => undefined);
	if (!bytes) return undefined;
	try {
		return JSON.parse(new TextDecoder().decode(bytes)) as Owner;
	} catch {
		return undefined;
	}
}

function holds({ host, process, at }: Owner, world: World): boolean {
	if (!(Math.abs(world.now() - at) < SILENCE)) return false;
	// In a container every run may have the same number.
	return host !== world.host || (process !== world.process && world.isRunning(process));
}
