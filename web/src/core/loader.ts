/** Fetches and compiles the core, with a message for each failure. */
import { Core, type TimePassed } from "./core";
import { UnsupportedError } from "./errors";
import { text } from "./messages.generated";

/** Browsers compile while they fetch only with exactly this type. */
const MIME = "application/wasm";
const WASM_MAGIC = [0x00, 0x61, 0x73, 0x6d]; // "\0asm"

/**
 * Fetches and compiles a module, at the same time where the server names the right type, else one after the other.
 * @param note receives warnings
 * @throws UnsupportedError where there is no WebAssembly, no response, or no core in the response
 */
export async function compileCore(
	url: string | URL,
	note: (warning: string) => void = () => {},
): Promise<WebAssembly.Module> {
	requireWebAssembly();
	const response = await fetchCore(url);
	const type = response.headers.get("content-type")?.trim().toLowerCase() ?? "";
	if (type === MIME && "compileStreaming" in WebAssembly) {
		return WebAssembly.compileStreaming(response).catch((cause: unknown) =>
			cause instanceof WebAssembly.CompileError ? throwerOfNotACore(type)(cause) : throwNotFetched(cause),
		);
	}
	const module = await compileBytes(new Uint8Array(await response.arrayBuffer().catch(throwNotFetched)), type);
	if (type !== MIME) note(type ? text("slow_content_type", { type }) : text("slow_without_content_type"));
	return module;
}

/** Instantiates a core from the bytes of a model's wasm file, for Node; `timePassed` as in `Core.instantiate`. */
export async function loadCoreFromBytes(bytes: BufferSource, timePassed?: TimePassed): Promise<Core> {
	requireWebAssembly();
	const view = ArrayBuffer.isView(bytes)
		? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength)
		: new Uint8Array(bytes);
	return Core.instantiate(await compileBytes(view, "bytes"), timePassed);
}

/** Throws an UnsupportedError where there is no WebAssembly. */
function requireWebAssembly(): void {
	if (typeof WebAssembly === "object") return;
	throw new UnsupportedError("webassembly", text.message("no_webassembly"));
}

/** Fetches a file; throws an UnsupportedError where the host cannot be reached or refuses. */
async function fetchCore(url: string | URL): Promise<Response> {
	const response = await fetch(url).catch(throwNotFetched);
	if (response.ok) return response;
	throw new UnsupportedError("fetch", text.message("fetch_refused", { status: String(response.status) }));
}

/** Throws the error of a host that cannot be reached. */
function throwNotFetched(cause: unknown): never {
	throw new UnsupportedError("fetch", text.message("fetch_failed"), { cause });
}

/**
 * Compiles the bytes of a module.
 * @param type content type of the response, for the error's message
 */
async function compileBytes(bytes: Uint8Array<ArrayBuffer>, type: string): Promise<WebAssembly.Module> {
	if (WASM_MAGIC.some((byte, index) => bytes[index] !== byte)) throwerOfNotACore(type)();
	return WebAssembly.compile(bytes).catch(throwerOfNotACore(type));
}

/**
 * Returns a function that throws the error of bytes that are no WebAssembly.
 * @param type content type of the response; empty where it has none
 */
function throwerOfNotACore(type: string): (cause?: unknown) => never {
	return (cause) => {
		const message = type ? text.message("invalid_wasm", { type }) : text.message("invalid_wasm_untyped");
		throw new UnsupportedError("core", message, { cause });
	};
}
