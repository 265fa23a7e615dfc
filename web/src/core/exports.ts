/** The core's exports, as exports/panicle.h declares them. */

type Pointer = number;

export interface CoreExports {
	memory: WebAssembly.Memory;
	_initialize?(): void;
	panicle_abi(): number;
	panicle_allocate(bytes: number): Pointer;
	panicle_release(memory: Pointer): void;
	panicle_grow(request: Pointer, bytes: number): Pointer;
	/** This function and the next are absent from modules of models without grammars. */
	panicle_compile?(text: Pointer, bytes: number): Pointer;
	panicle_forget?(program: number): void;
}

/** The version of the core's interface that this code supports. */
export const ABI = 5;

const FUNCTIONS = ["abi", "allocate", "release", "grow"];

/** Returns whether a module's exports are those of a core. */
export function areCoreExports(exports: object): exports is CoreExports {
	const has = exports as Record<string, unknown>;
	return (
		has.memory instanceof WebAssembly.Memory && FUNCTIONS.every((name) => typeof has[`panicle_${name}`] === "function")
	);
}
