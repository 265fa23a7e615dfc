/**
 * The app's service worker: the app without a network, and files of specimens by their addresses. A classic script, for
 * every browser with service workers; docs/offline.md describes its behaviour.
 */
import type { Service } from "../service/service";
import { type Built, isNamedByContent } from "./built";
import { CachedApp } from "./cached_app";
import { MAX_WAITING, refusal, type SpecimenRequest, type ToServiceWorker } from "./messages";
import { text } from "./messages.generated";
import { grownByPage, responseOf } from "./page_growth";
import type { MakeSpecimens } from "./specimens";
import { wantedBy } from "./wanted";
import type { WorkerScope } from "./worker_scope";

/** Inserted by the build. */
declare const __BUILT__: Built;

const worker = self as unknown as WorkerScope & { panicleSpecimens?: MakeSpecimens };
const built = __BUILT__;
const { scope } = worker.registration;
const app = new CachedApp({ scope, built, caches, fetch: (url, init) => fetch(url, init) });
/** The script that serves specimens, and the cores. */
const IN_GROWTH = new Set([built.specimens, ...Object.values(built.cores)]);
let service: Service | undefined;
let growingHere = 0;

worker.addEventListener("install", (event) => event.waitUntil(install()));
worker.addEventListener("activate", (event) => event.waitUntil(Promise.all([sweep(), worker.clients.claim()])));

worker.addEventListener("message", (event) => {
	const message = event.data as ToServiceWorker;
	event.waitUntil(message.type === "take over" ? worker.skipWaiting() : opened(message.keep));
});

worker.addEventListener("fetch", (event) => {
	const { request } = event;
	const wanted = wantedBy(request, scope);
	if (wanted === "specimen") event.respondWith(answerSpecimen(request));
	else if (wanted && IN_GROWTH.has(wanted.file)) event.respondWith(answerGrowth(request, wanted.file));
	else if (wanted && (Object.hasOwn(built.files, wanted.file) || isNamedByContent(wanted.file)))
		event.respondWith(answerFile(request, wanted.file));
});

/** Stores the script that serves specimens, and this build where another one is stored already. */
async function install(): Promise<void> {
	// The browser stores imports with the worker, and allows only these later.
	worker.importScripts(scope + built.specimens);
	// Without a cached build, pages still come from the network: take over at once.
	if (!(await app.isOtherWhole())) return worker.skipWaiting();
	await app.fill();
}

/**
 * Handles a page that has been opened: stores the whole app where `keep` is set, and deletes builds that no page uses.
 */
async function opened(keep: boolean): Promise<void> {
	// Claims pages that were loaded without the worker.
	await worker.clients.claim();
	// Without a network, or after a deploy, some files cannot be fetched: the next page tries again.
	if (keep && !(await app.isWhole())) await app.fill().catch(() => {});
	await sweep();
}

/** Deletes cached builds, except this one and those of open pages. */
async function sweep(): Promise<void> {
	const { installing, waiting } = worker.registration;
	if (installing || waiting) return;
	const { held = [] } = await navigator.locks.query();
	await app.sweep(held.flatMap(({ name }) => (name?.startsWith(scope) ? [name] : [])));
}

/** Answers a request for a file of the app: from the cache, or else from the network. */
async function answerFile(request: Request, path: string): Promise<Response> {
	return (await app.find(path).catch(() => undefined)) ?? fetch(request);
}

/** Stores the script and the cores that a page's worker fetches, so that later growth needs no network. */
async function answerGrowth(request: Request, path: string): Promise<Response> {
	return (await app.find(path).catch(() => undefined)) ?? app.bring(path).catch(() => fetch(request));
}

/** Answers a request for a specimen's file: an open page grows it, or else this worker. */
async function answerSpecimen(request: Request): Promise<Response> {
	const pages = await worker.clients.matchAll({ type: "window" });
	return (await grownByPage(pages, requestOf(request), { signal: request.signal })) ?? answerHere(request);
}

/** Converts a request for a specimen to a message for the worker that grows it. */
function requestOf({ url, method, headers }: Request): SpecimenRequest {
	const tag = headers.get("if-none-match");
	const cores = Object.entries(built.cores).map(([wasm, path]) => [wasm, scope + path]);
	return {
		url,
		method,
		headers: tag === null ? {} : { "if-none-match": tag },
		script: scope + built.specimens,
		cores: Object.fromEntries(cores),
		release: built.release,
	};
}

/** Answers on this thread, which blocks it, where no page grows specimens. */
async function answerHere(request: Request): Promise<Response> {
	if (growingHere >= MAX_WAITING) return responseOf(refusal(text("too_many_requests")));
	growingHere++;
	try {
		service ??= startService();
		return await service(request);
	} catch {
		return new Response(`${text("not_here")}\n`, { status: 500 });
	} finally {
		growingHere--;
	}
}

/** Creates the service that grows specimens in this worker. */
function startService(): Service {
	if (!worker.panicleSpecimens) worker.importScripts(scope + built.specimens);
	const make = worker.panicleSpecimens as MakeSpecimens;
	return make(async (wasm) => (await app.bring(built.cores[wasm])).arrayBuffer(), built.release);
}
