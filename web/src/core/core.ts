/** One instance of the core: the only code that touches its memory. */
import { type Block, Columns, copyContainer, writeContainer } from "./container";
import { CORE_REASONS, CoreError, CoreTrap, UnsupportedError } from "./errors";
import { ABI, areCoreExports, type CoreExports } from "./exports";

/** Bytes of the largest request: parameters, lists and the longest grammar stay far below. */
const MOST_REQUEST_BYTES = 1024 * 1024;
/** Compiled grammars that are kept: those of the procedures, and of a text before and after an edit. */
const MOST_PROGRAMS = 8;
const encoder = new TextEncoder();
const WASI_NOT_SUPPORTED = 52; // ENOSYS

/** What a request grew into. */
export interface Answer {
	/** What has grown, by name; the caller's own. */
	columns: Columns;
	/** How long growing took. */
	milliseconds: number;
}

/** The share of a time limit that has passed, 1 or more when the time is over. */
export type TimePassed = () => number;

export class Core {
	readonly #exports: CoreExports;
	/** Handles of compiled grammars by their texts, those used last at the end. */
	readonly #programs = new Map<string, number>();
	#trapped = false;

	private constructor(exports: CoreExports) {
		this.#exports = exports;
	}

	/**
	 * Brings a compiled core to life.
	 * @param timePassed the share of the time limit that has passed: a plant ends as far as it has grown when it is 1.
	 * Called about once a millisecond while a plant grows. The default is no limit
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

	/** Bytes of memory that the instance holds. */
	get memoryBytes(): number {
		return this.#exports.memory.buffer.byteLength;
	}

	/**
	 * Grows a request, as a model's `encode` writes it. What comes back is the caller's own. A grammar is compiled once
	 * and kept for the next requests with the same text.
	 *
	 * @throws CoreError where the request cannot be grown; the instance stays good
	 * @throws CoreTrap where the core broke; the instance must be thrown away
	 */
	grow(blocks: readonly Block[]): Answer {
		return this.#guarded(() => {
			const compiled = blocks.map((block) => (block.name === "grammar" ? this.#compiled(block) : block));
			return this.#grown(writeContainer(compiled));
		});
	}

	/** The same for a request that is laid out already, whatever it is. */
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

	/** The handle of a grammar's text, in the place of the text. */
	#compiled({ data: text }: Block): Block {
		if (typeof text !== "string") throw new CoreError("bad request", "A grammar is a text.");
		const known = this.#programs.get(text);
		// The newest stands last: what has not been used for longest is forgotten first.
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

	/** Copies bytes in, calls, copies the answer out. */
	#call(input: Uint8Array, call: (pointer: number, bytes: number) => number): Columns {
		if (input.length > MOST_REQUEST_BYTES) throw new CoreError("limit", "The request is larger than 1 MiB.");
		const exports = this.#exports;
		const pointer = exports.panicle_allocate(input.length) >>> 0;
		if (pointer === 0) throw new CoreError("limit", "There is no memory for the request; close other pages.");
		new Uint8Array(exports.memory.buffer, pointer, input.length).set(input);
		const answer = call(pointer, input.length) >>> 0;
		exports.panicle_release(pointer);
		if (answer === 0) throw new CoreError("limit", "There is no memory for the plant; make it smaller.");
		// The buffer is asked for after the call: it is another one where the memory has grown.
		const columns = new Columns(copyContainer(exports.memory.buffer as ArrayBuffer, answer));
		exports.panicle_release(answer);
		const [reason, line, column] = columns.uint32("status");
		if (reason === 0) return columns;
		throw new CoreError(CORE_REASONS[reason] ?? "bad request", columns.text("message"), line, column);
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
