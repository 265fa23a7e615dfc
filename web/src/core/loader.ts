/** Fetches and compiles the core, with a message for each failure. */
import { Core, type TimePassed } from "./core";
import { UnsupportedError } from "./errors";

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
	note: (text: string) => void = () => {},
): Promise<WebAssembly.Module> {
	requireWebAssembly();
	const response = await fetchCore(url);
	const type = response.headers.get("content-type")?.trim().toLowerCase() ?? "";
	if (type === MIME && "compileStreaming" in WebAssembly) {
		return WebAssembly.compileStreaming(response).catch((cause: unknown) =>
			cause instanceof WebAssembly.CompileError ? notACore(type)(cause) : notFetched(cause),
		);
	}
	const module = await compileBytes(new Uint8Array(await response.arrayBuffer().catch(notFetched)), type);
	if (type !== MIME)
		note(`The server sends the core as ${type || "nothing in particular"}; as ${MIME} it would start faster.`);
	return module;
}

/** A core from the bytes of a model's wasm file, for Node; `timePassed` as in `Core.instantiate`. */
export async function loadCoreFromBytes(bytes: BufferSource, timePassed?: TimePassed): Promise<Core> {
	requireWebAssembly();
	const view = ArrayBuffer.isView(bytes)
		? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength)
		: new Uint8Array(bytes);
	return Core.instantiate(await compileBytes(view, "bytes"), timePassed);
}

function requireWebAssembly(): void {
	if (typeof WebAssembly === "object") return;
	throw new UnsupportedError(
		"webassembly",
		"This browser runs no WebAssembly, which growing needs; allow it, or open the page in another browser.",
	);
}

async function fetchCore(url: string | URL): Promise<Response> {
	const response = await fetch(url).catch(notFetched);
	if (response.ok) return response;
	const answer = `the server answered ${response.status}`;
	throw new UnsupportedError("fetch", `The core could not be fetched (${answer}); try again later.`);
}

function notFetched(cause: unknown): never {
	const message = "The core could not be fetched; check the connection and try again.";
	throw new UnsupportedError("fetch", message, { cause });
}

async function compileBytes(bytes: Uint8Array<ArrayBuffer>, type: string): Promise<WebAssembly.Module> {
	if (WASM_MAGIC.some((byte, index) => bytes[index] !== byte)) notACore(type)();
	return WebAssembly.compile(bytes).catch(notACore(type));
}

function notACore(type: string): (cause?: unknown) => never {
	return (cause) => {
		throw new UnsupportedError(
			"core",
			`What came in place of the core (${type || "of no named type"}) cannot be run; reload the page.`,
			{
				cause,
			},
		);
	};
}
