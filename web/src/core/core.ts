/** One instance of the core: the only code that touches its memory. */
import { type Block, Columns, containerBytes, writeContainer } from "./container";
import { CORE_REASONS, CoreError, CoreTrap, UnsupportedError } from "./errors";
import { ABI, areCoreExports, type CoreExports } from "./exports";

/** Bytes of the largest request: parameters, lists and the longest grammar stay far below. */
const MOST_REQUEST_BYTES = 1024 * 1024;
const WASI_NOT_SUPPORTED = 52; // ENOSYS

/** What a request grew into. */
export interface Answer {
	/** What has grown, by name; the caller's own. */
	columns: Columns;
	/** How long growing took. */
	milliseconds: number;
}

export class Core {
	readonly #exports: CoreExports;
	#trapped = false;

	private constructor(exports: CoreExports) {
		this.#exports = exports;
	}

	/** Brings a compiled core to life. Throws UnsupportedError where the module is no core, or one of another version. */
	static async instantiate(module: WebAssembly.Module): Promise<Core> {
		const { exports } = await WebAssembly.instantiate(module, stubs(module));
		if (!areCoreExports(exports)) {
			throw new UnsupportedError("core", "What was loaded in place of the core is something else; reload the page.");
		}
		exports._initialize?.();
		if (exports.panicle_abi() !== ABI) {
			throw new UnsupportedError("core", "The core and the page are of different versions; reload the page.");
		}
		return new Core(exports);
	}

	/** Bytes of memory that the instance holds. */
	get memoryBytes(): number {
		return this.#exports.memory.buffer.byteLength;
	}

	/**
	 * Grows a request, as a model's `encode` writes it. What comes back is the caller's own; nothing is kept.
	 *
	 * @throws CoreError where the request cannot be grown; the instance stays good
	 * @throws CoreTrap where the core broke; the instance must be thrown away
	 */
	grow(blocks: readonly Block[]): Answer {
		return this.growBytes(writeContainer(blocks));
	}

	/** The same for a request that is laid out already. */
	growBytes(request: Uint8Array): Answer {
		if (this.#trapped) throw new CoreTrap("This core has broken before; another is needed.");
		if (request.length > MOST_REQUEST_BYTES) throw new CoreError("limit", "The request is larger than 1 MiB.");
		try {
			return this.#growCopied(request);
		} catch (error) {
			if (error instanceof CoreError) throw error;
			this.#trapped = true;
			throw new CoreTrap(`The core broke while growing (${error instanceof Error ? error.message : error}).`);
		}
	}

	#growCopied(request: Uint8Array): Answer {
		const exports = this.#exports;
		const pointer = exports.panicle_allocate(request.length) >>> 0;
		if (pointer === 0) throw new CoreError("limit", "There is no memory for the request; close other pages.");
		new Uint8Array(exports.memory.buffer, pointer, request.length).set(request);
		const from = performance.now();
		const answer = exports.panicle_grow(pointer, request.length) >>> 0;
		const milliseconds = performance.now() - from;
		exports.panicle_release(pointer);
		if (answer === 0) throw new CoreError("limit", "There is no memory for the plant; make it smaller.");
		const columns = new Columns(this.#copyOut(answer));
		exports.panicle_release(answer);
		const [reason, line, column] = columns.words("status");
		if (reason !== 0) {
			throw new CoreError(CORE_REASONS[reason] ?? "bad request", columns.text("message"), line, column);
		}
		return { columns, milliseconds };
	}

	/** A container in the core's memory as bytes of our own: no view of the memory leaves this file. */
	#copyOut(pointer: number): Uint8Array<ArrayBuffer> {
		// Asked for after the growth: the buffer is another one where the memory has grown.
		const heap = this.#exports.memory.buffer as ArrayBuffer;
		const bytes = containerBytes(heap, pointer);
		if (pointer + bytes > heap.byteLength) throw new RangeError("the answer lies outside the core's memory");
		return new Uint8Array(heap.slice(pointer, pointer + bytes));
	}
}

/**
 * Something to link every function that the module imports: the core calls none of them on its way, they come with the
 * C library. Leaving the program is the exception: it must not return.
 */
function stubs(module: WebAssembly.Module): WebAssembly.Imports {
	const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
	for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
		if (kind !== "function") continue;
		imports[from] ??= {};
		imports[from][name] = name === "proc_exit" || name === "abort" ? leave : () => WASI_NOT_SUPPORTED;
	}
	return imports;
}

function leave(code?: number): never {
	throw new WebAssembly.RuntimeError(`left with status ${code ?? "unknown"}`);
}
