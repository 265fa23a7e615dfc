/** One instance of the core: the only code that touches its memory. */
import { CoreError, CoreTrap, UnsupportedError } from "./errors";
import { ABI, areCoreExports, type CoreExports } from "./exports";
import type { Grown } from "../models/bunch/grown";
import { readGrown } from "../models/bunch/read_grown";
import { Sections } from "./sections";

/** Bytes of the largest request: the header, the parameters, `n` and the longest grammar stay far below. */
const MOST_REQUEST_BYTES = 1024 * 1024;
const WASI_NOT_SUPPORTED = 52; // ENOSYS

export class Core {
	private trapped = false;

	private constructor(private readonly exports: CoreExports) {}

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
		return this.exports.memory.buffer.byteLength;
	}

	/**
	 * Grows a request (models/bunch/request.ts). What comes back is the caller's own; nothing is kept.
	 *
	 * @throws CoreError where the request cannot be grown; the instance stays good
	 * @throws CoreTrap where the core broke; the instance must be thrown away
	 */
	grow(request: Uint8Array): Grown {
		if (this.trapped) throw new CoreTrap("This core has broken before; another is needed.");
		if (!(request instanceof Uint8Array)) throw new CoreError("bad request", "A request is a Uint8Array.");
		if (request.length % 4 !== 0) throw new CoreError("bad request", "A request is a whole number of 32-bit words.");
		if (request.length > MOST_REQUEST_BYTES) throw new CoreError("limit", "The request is larger than 1 MiB.");
		try {
			return this.growCopied(request);
		} catch (error) {
			if (error instanceof CoreError) throw error;
			this.trapped = true;
			throw new CoreTrap(`The core broke while growing (${error instanceof Error ? error.message : error}).`);
		}
	}

	private growCopied(request: Uint8Array): Grown {
		const { exports } = this;
		const pointer = exports.panicle_allocate(request.length) >>> 0;
		if (pointer === 0) throw new CoreError("limit", "There is no memory for the request; close other pages.");
		new Uint8Array(exports.memory.buffer, pointer, request.length).set(request);
		const from = performance.now();
		const result = exports.panicle_grow(pointer, request.length) >>> 0;
		const elapsed = performance.now() - from;
		exports.panicle_release(pointer);
		if (result === 0) throw new CoreError("limit", "There is no memory for the bunch; make it smaller.");
		try {
			return readGrown(new Sections(exports, result), elapsed);
		} finally {
			exports.panicle_free(result);
		}
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
