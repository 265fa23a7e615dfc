/**
 * Serves specimens as a script of its own: in a worker of a page, and in the service worker, which runs it when no page
 * grows specimens. It is classic: service workers cannot `import()`.
 */
import { loadCoreFromBytes } from "../core/loader";
import { makeService, type Service } from "../service/service";
import type { SpecimenAnswer, SpecimenRequest } from "./messages";

/** @param bringCore fetches a core by the name of its file */
export type MakeSpecimens = (bringCore: (wasm: string) => Promise<ArrayBuffer>, release: string) => Service;

const makeSpecimens: MakeSpecimens = (bringCore, release) =>
	makeService({ release, loadCore: async (wasm) => loadCoreFromBytes(await bringCore(wasm)) });

interface Scope {
	panicleSpecimens?: MakeSpecimens;
	DedicatedWorkerGlobalScope?: unknown;
	onmessage?: (event: MessageEvent<SpecimenRequest>) => void;
	postMessage(answer: SpecimenAnswer, transfer: Transferable[]): void;
}

const scope = globalThis as unknown as Scope;
// Classic scripts have no exports.
scope.panicleSpecimens = makeSpecimens;
if (scope.DedicatedWorkerGlobalScope) answerThePage();

/** Answers messages in a page's worker; the service is created with the first request. */
function answerThePage(): void {
	let service: Service | undefined;
	scope.onmessage = async ({ data: { url, method, headers, cores, release } }) => {
		try {
			service ??= makeSpecimens((wasm) => fetchCore(cores[wasm]), release);
			const answer = await service(new Request(url, { method, headers }));
			const body = new Uint8Array(await answer.arrayBuffer());
			const { status } = answer;
			scope.postMessage({ type: "answer", status, headers: Object.fromEntries(answer.headers), body }, [body.buffer]);
		} catch {
			scope.postMessage({ type: "unable" }, []);
		}
	};
}

/** Fetches the bytes of a core; throws where the host refuses. */
async function fetchCore(address: string): Promise<ArrayBuffer> {
	const response = await fetch(address);
	if (!response.ok) throw new Error(`${address} could not be fetched: ${response.status}`);
	return response.arrayBuffer();
}
