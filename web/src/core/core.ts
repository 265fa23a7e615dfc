/** One instance of the core: the only code that accesses its memory. */
import { type Block, Columns, copyContainer, writeContainer } from "./container";
import { CORE_REASONS, CoreError, CoreTrap, UnsupportedError } from "./errors";
import { ABI, areCoreExports, type CoreExports } from "./exports";

/** The largest request in bytes: parameters, lists and the longest grammar stay far below. */
const MOST_REQUEST_BYTES = 1024 * 1024;
/** The number of cached compiled grammars: those of the presets' procedures, and of a text before and after an edit. */
const MOST_PROGRAMS = 8;
const encoder = new TextEncoder();
const WASI_NOT_SUPPORTED = 52; // ENOSYS

/** The result of a request. */
export interface Answer {
	/** The columns by name; they belong to the caller. */
	columns: Columns;
	/** The time of growing. */
	milliseconds: number;
}

/** Returns the elapsed share of a time limit, 1 or more once the time is over. */
export type TimePassed = () => number;

export class Core {
	readonly #exports: CoreExports;
	/** Handles of compiled grammars by text, the last used at the end. */
	readonly #programs = new Map<string, number>();
	#trapped = false;

	private constructor(exports: CoreExports) {
		this.#exports = exports;
	}

	/**
	 * Instantiates a compiled core.
	 * @param timePassed the elapsed share of the time limit: at 1 the plant stops growing. Called about once a
	 * millisecond while a plant grows. The default is no limit
	 * @throws UnsupportedError where the module is no core, or one of another version
	 */
	static async instantiate(module: WebAssembly.Module, timePassed: TimePassed = () => 0): Promise<Core> {
		const imports = stubs(module);
		if (imports.env) imports.env.panicle_time_passed = timePassed;
		const { exports } = await WebAssembly.instantiate(module, imports);
		if (!areCoreExports(exports)) {
			throw new UnsupportedError("core", "What was loaded in place of the core is something else; reload the page.");
		}
		exports._initialize?.();
		if (exports.panicle_abi() !== ABI) {
			throw new UnsupportedError("core", "The core and the page are of different versions; reload the page.");
		}
		return new Core(exports);
	}

	/** Bytes of memory of the instance. */
	get memoryBytes(): number {
		return this.#exports.memory.buffer.byteLength;
	}

	/**
	 * Grows a request that a model's `encode` has made. The answer belongs to the caller. A grammar is compiled once
	 * and cached for later requests with the same text.
	 *
	 * @throws CoreError where the request cannot be grown; the instance stays valid
	 * @throws CoreTrap where the core crashed; discard the instance
	 */
	grow(blocks: readonly Block[]): Answer {
		return this.#guarded(() => {
			const compiled = blocks.map((block) => (block.name === "grammar" ? this.#compiled(block) : block));
			return this.#grown(writeContainer(compiled));
		});
	}

	/** Grows a request that is already encoded, without checks. */
	growBytes(request: Uint8Array): Answer {
		return this.#guarded(() => this.#grown(request));
	}

	#guarded<Result>(work: () => Result): Result {
		if (this.#trapped) throw new CoreTrap("This core has broken before; another is needed.");
		try {
			return work();
		} catch (error) {
			if (error instanceof CoreError) throw error;
			this.#trapped = true;
			throw new CoreTrap(`The core broke while growing (${error instanceof Error ? error.message : error}).`);
		}
	}

	/** Replaces a grammar's text by the handle of the compiled grammar. */
	#compiled({ data: text }: Block): Block {
		if (typeof text !== "string") throw new CoreError("bad request", "A grammar is a text.");
		const known = this.#programs.get(text);
		// Reinsert the text at the end of the map: the first one is evicted next.
		if (known !== undefined) this.#programs.delete(text);
		const program = known ?? this.#compile(text);
		this.#programs.set(text, program);
		return { name: "program", data: Uint32Array.of(program) };
	}

	#compile(text: string): number {
		const { panicle_compile, panicle_forget } = this.#exports;
		if (!panicle_compile) throw new CoreError("bad request", "The model grows from no grammar; leave it out.");
		const [oldest] = this.#programs;
		if (oldest && this.#programs.size >= MOST_PROGRAMS) {
			panicle_forget?.(oldest[1]);
			this.#programs.delete(oldest[0]);
		}
		const columns = this.#call(encoder.encode(text), panicle_compile);
		return columns.uint32("program")[0];
	}

	#grown(request: Uint8Array): Answer {
		let milliseconds = 0;
		const columns = this.#call(request, (pointer, bytes) => {
			const from = performance.now();
			const answer = this.#exports.panicle_grow(pointer, bytes);
			milliseconds = performance.now() - from;
			return answer;
		});
		return { columns, milliseconds };
	}

	/** Copies the input in, calls, and copies the answer out. */
	#call(input: Uint8Array, call: (pointer: number, bytes: number) => number): Columns {
		if (input.length > MOST_REQUEST_BYTES) throw new CoreError("limit", "The request is larger than 1 MiB.");
		const exports = this.#exports;
		const pointer = exports.panicle_allocate(input.length) >>> 0;
		if (pointer === 0) throw new CoreError("limit", "There is no memory for the request; close other pages.");
		new Uint8Array(exports.memory.buffer, pointer, input.length).set(input);
		const answer = call(pointer, input.length) >>> 0;
		exports.panicle_release(pointer);
		if (answer === 0) throw new CoreError("limit", "There is no memory for the plant; make it smaller.");
		// Read the buffer after the call: it is a new one where the memory has grown.
		const columns = new Columns(copyContainer(exports.memory.buffer as ArrayBuffer, answer));
		exports.panicle_release(answer);
		const [reason, line, column] = columns.uint32("status");
		if (reason === 0) return columns;
		throw new CoreError(CORE_REASONS[reason] ?? "bad request", columns.text("message"), line, column);
	}
}

/**
 * Stubs for every function that the module imports. They come with the C library, and the core calls none of them,
 * except for leaving the program, which must not return.
 */
function stubs(module: WebAssembly.Module): WebAssembly.Imports {
	const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
	for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
		if (kind !== "function") continue;
		imports[from] ??= {};
		imports[from][name] = name === "proc_exit" || name === "abort" ? exitProgram : () => WASI_NOT_SUPPORTED;
	}
	return imports;
}

function exitProgram(code?: number): never {
	throw new WebAssembly.RuntimeError(`left with status ${code ?? "unknown"}`);
}
