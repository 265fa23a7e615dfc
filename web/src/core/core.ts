/** One instance of the core: the only code that accesses its memory. */
import { type Block, Columns, copyContainer, writeContainer } from "./container";
import { CORE_REASONS, CoreError, CoreTrap, UnsupportedError } from "./errors";
import { ABI, areCoreExports, type CoreExports } from "./exports";
import { text } from "./messages.generated";

/** The largest request in bytes: parameters, lists and the longest grammar stay far below. */
const MAX_REQUEST_BYTES = 1024 * 1024;
/** The number of cached compiled grammars: those of the presets' procedures, and of a text before and after an edit. */
const MAX_PROGRAMS = 8;
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
			throw new UnsupportedError("core", text.message("invalid_exports"));
		}
		exports._initialize?.();
		if (exports.panicle_abi() !== ABI) {
			throw new UnsupportedError("core", text.message("other_version"));
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
			const compiled = blocks.map((block) => (block.name === "grammar" ? this.#compiledBlock(block) : block));
			return this.#callGrow(writeContainer(compiled));
		});
	}

	/** Grows a request that is already encoded, without checks. */
	growBytes(request: Uint8Array): Answer {
		return this.#guarded(() => this.#callGrow(request));
	}

	/**
	 * Runs `work`, which calls the core. Errors that the core reports (`CoreError`) leave it usable; any other exception
	 * is a crash, after which its memory is undefined: this call and every later one throw `CoreTrap`.
	 */
	#guarded<Result>(work: () => Result): Result {
		if (this.#trapped) throw new CoreTrap(text.message("crashed_before"));
		try {
			return work();
		} catch (error) {
			if (error instanceof CoreError) throw error;
			this.#trapped = true;
			throw new CoreTrap(text.message("crashed", { reason: error instanceof Error ? error.message : String(error) }));
		}
	}

	/** Replaces the block with a grammar's text by one with the handle of the compiled grammar. */
	#compiledBlock({ data: grammar }: Block): Block {
		if (typeof grammar !== "string") throw new CoreError("bad request", text.message("grammar_not_text"));
		const known = this.#programs.get(grammar);
		// Reinsert the text at the end of the map: the first one is evicted next.
		if (known !== undefined) this.#programs.delete(grammar);
		const program = known ?? this.#compile(grammar);
		this.#programs.set(grammar, program);
		return { name: "program", data: Uint32Array.of(program) };
	}

	/**
	 * Compiles a grammar in the core and returns the program's handle. At most MAX_PROGRAMS programs are stored: the
	 * oldest is freed first.
	 */
	#compile(grammar: string): number {
		const { panicle_compile, panicle_forget } = this.#exports;
		if (!panicle_compile) throw new CoreError("bad request", text.message("no_grammar"));
		const [oldest] = this.#programs;
		if (oldest && this.#programs.size >= MAX_PROGRAMS) {
			panicle_forget?.(oldest[1]);
			this.#programs.delete(oldest[0]);
		}
		const columns = this.#callWithInput(encoder.encode(grammar), panicle_compile);
		return columns.uint32("program")[0];
	}

	/**
	 * Calls the core to grow a plant. `milliseconds` is the duration of the core's own call, without copying the answer.
	 */
	#callGrow(request: Uint8Array): Answer {
		let milliseconds = 0;
		const columns = this.#callWithInput(request, (pointer, bytes) => {
			const from = performance.now();
			const answer = this.#exports.panicle_grow(pointer, bytes);
			milliseconds = performance.now() - from;
			return answer;
		});
		return { columns, milliseconds };
	}

	/**
	 * Copies `input` into the core's memory, calls, and copies the answer out.
	 * @param call receives the position and the length of the input, and returns the position of the answer
	 */
	#callWithInput(input: Uint8Array, call: (pointer: number, bytes: number) => number): Columns {
		if (input.length > MAX_REQUEST_BYTES) throw new CoreError("limit", text.message("request_too_large"));
		const exports = this.#exports;
		const pointer = exports.panicle_allocate(input.length) >>> 0;
		if (pointer === 0) throw new CoreError("limit", text.message("no_memory_for_request"));
		new Uint8Array(exports.memory.buffer, pointer, input.length).set(input);
		const answer = call(pointer, input.length) >>> 0;
		exports.panicle_release(pointer);
		if (answer === 0) throw new CoreError("limit", text.message("no_memory_for_plant"));
		// Read the buffer after the call: it is a new one where the memory has grown.
		const columns = new Columns(copyContainer(exports.memory.buffer as ArrayBuffer, answer));
		exports.panicle_release(answer);
		const [reason, line, column] = columns.uint32("status");
		if (reason === 0) return columns;
		throw new CoreError(CORE_REASONS[reason] ?? "bad request", columns.text("message"), line, column);
	}
}

/**
 * Returns functions for everything that the module imports. The imports come with the C library, and the core calls
 * none of them, except for leaving the program, which must not return.
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

/** Replaces the C library's function that ends the program: throws. */
function exitProgram(code?: number): never {
	throw new WebAssembly.RuntimeError(`left with status ${code ?? "unknown"}`);
}
