/**
 * The lock of a series' table, a file beside it: one process at a time writes a table. A lock expires when its process
 * has ended or has not renewed it for five minutes.
 */
import { randomUUID } from "node:crypto";
import { MessageError } from "../locale/message_error";
import { text } from "./messages.generated";
import type { CommandEnvironment } from "./surroundings";
import { optionError } from "./usage";
import { writing } from "./writing";

/** The content of the lock file: the process that holds the lock. */
interface Owner {
	readonly host: string;
	readonly process: number;
	/** A random id of this lock. */
	readonly token: string;
	/** When it was last renewed, in milliseconds since 1970. */
	readonly at: number;
}

/** Milliseconds without a renewal after which a lock expires, on any machine. */
const EXPIRY = 5 * 60_000;
/** The least milliseconds between two renewals. */
const RENEWAL_INTERVAL = 20_000;
/** Attempts to take the lock: another process may take it just after it was released. */
const TRIES = 3;

type World = Pick<
	CommandEnvironment,
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
	 * Takes the lock of a table, also one that has expired.
	 * @param table the path of the table
	 * @throws UsageError where another process is writing it
	 */
	static async acquire(table: string, world: World): Promise<TableLock> {
		const path = `${table}.lock`;
		const owner = { host: world.host, process: world.process, token: randomUUID(), at: world.now() };
		for (let tries = 0; tries < TRIES; tries++) {
			if (await writing(path, () => world.createFile(path, JSON.stringify(owner))))
				return new TableLock(path, owner, world);
			const other = await readOwner(path, world);
			if (other && isValid(other, world)) {
				const seconds = Math.max(0, Math.round((world.now() - other.at) / 1000));
				const named = { process: String(other.process), host: other.host, seconds };
				throw optionError(`--out ${table}`, text.message("table_in_use_by", named));
			}
			await world.removeFile(path);
		}
		throw optionError(`--out ${table}`, text.message("table_in_use"));
	}

	/**
	 * Renews the lock. Call it before every write.
	 * @throws Error where another process has taken the lock after it expired
	 */
	async renew(): Promise<void> {
		const owner = await readOwner(this.#path, this.#world);
		if (owner?.token !== this.#owner.token) throw new MessageError(text.message("lock_taken", { file: this.#path }));
		if (this.#world.now() - this.#owner.at < RENEWAL_INTERVAL) return;
		this.#owner = { ...this.#owner, at: this.#world.now() };
		await writing(this.#path, () => this.#world.replaceFile(this.#path, JSON.stringify(this.#owner)));
	}

	/** Removes the lock, unless another process has taken it. */
	async release(): Promise<void> {
		const owner = await readOwner(this.#path, this.#world);
		if (owner?.token === this.#owner.token) await this.#world.removeFile(this.#path);
	}
}

/**
 * The owner of the lock; undefined where there is no lock, or only part of one by a process that ended while writing.
 */
async function readOwner(path: string, world: World): Promise<Owner | undefined> {
	const bytes = await world.readFile(path).catch(() => undefined);
	if (!bytes) return undefined;
	try {
		return JSON.parse(new TextDecoder().decode(bytes)) as Owner;
	} catch {
		return undefined;
	}
}

/** Returns whether a lock has not expired. */
function isValid({ host, process, at }: Owner, world: World): boolean {
	if (!(Math.abs(world.now() - at) < EXPIRY)) return false;
	// Every run in a container may have the same process number: one’s own number is another run’s.
	return host !== world.host || (process !== world.process && world.isRunning(process));
}
