import { beforeEach, describe, expect, it } from "vitest";
import type { Built } from "../../../web/src/offline/built";
import { CachedApp } from "../../../web/src/offline/cached_app";
import { FakeCaches } from "./fake_caches";

const scope = "https://plants.example/app/";
const first: Record<string, string> = {
	"": "page 1",
	"assets/a-1.js": "a 1",
	"assets/same.js": "same",
	"icons/one.svg": "icon",
};
const second: Record<string, string> = {
	"": "page 2",
	"assets/a-2.js": "a 2",
	"assets/same.js": "same",
	"icons/one.svg": "icon",
};

let caches: FakeCaches;
let host: Record<string, string>;
let requested: { path: string; init: RequestInit }[];
beforeEach(() => {
	caches = new FakeCaches();
	requested = [];
});

/**
 * A build; its host has these files, and answers only with files that match the requested integrity, as browsers check.
 * @param failures how many requests for a file fail before one succeeds
 */
function app(id: string, files: Record<string, string>, at = scope, failures: Record<string, number> = {}): CachedApp {
	const left = { ...failures };
	const built: Built = { release: "1", id, files, cores: {}, specimens: "assets/specimens.js" };
	const fetch = async (url: string, init: RequestInit) => {
		const path = url.slice(at.length);
		requested.push({ path, init });
		if ((left[path] ?? 0) > 0) {
			left[path]--;
			throw new TypeError("Failed to fetch");
		}
		const text = host[path];
		if (text !== undefined && text !== init.integrity) throw new TypeError("integrity");
		return new Response(text ?? "", { status: text === undefined ? 404 : 200 });
	};
	return new CachedApp({ scope: at, built, caches: caches as unknown as CacheStorage, fetch });
}

async function filled(id: string, files: Record<string, string>, at = scope): Promise<CachedApp> {
	host = files;
	const stored = app(id, files, at);
	await stored.fill();
	return stored;
}

const text = async (answer: Promise<Response | undefined>) => (await answer)?.text();

describe("a kept app", () => {
	it("has every file, the page last", async () => {
		const stored = await filled("1", first);
		expect(await stored.isWhole()).toBe(true);
		expect(requested.at(-1)?.path).toBe("");
		expect(await caches.texts(`panicle ${scope} 1`)).toEqual(
			Object.fromEntries(Object.entries(first).map(([path, file]) => [scope + path, file])),
		);
		expect(await text(stored.find("assets/a-1.js"))).toBe("a 1");
		expect(await stored.find("specimens.glb")).toBeUndefined();
	});

	it("asks anew for what may have changed under its name, and only for that", async () => {
		await filled("1", first);
		const how = Object.fromEntries(requested.map(({ path, init }) => [path, init.cache]));
		expect(how).toEqual({
			"": "no-cache",
			"icons/one.svg": "no-cache",
			"assets/a-1.js": "default",
			"assets/same.js": "default",
		});
	});

	it("fetches a file again that failed once, while the others are stored", async () => {
		host = first;
		const stored = app("1", first, scope, { "icons/one.svg": 1, "assets/same.js": 2 });
		await stored.fill();
		expect(await stored.isWhole()).toBe(true);
		const times = (path: string) => requested.filter((each) => each.path === path).length;
		expect([times("icons/one.svg"), times("assets/same.js"), times("assets/a-1.js")]).toEqual([2, 3, 1]);
	});

	it.each(["assets/a-1.js", "icons/one.svg", ""])("is not whole without “%s”, and is when that comes", async (path) => {
		const { [path]: _, ...rest } = first;
		host = rest;
		const stored = app("1", first);
		await expect(stored.fill()).rejects.toThrow("404");
		expect(await stored.isWhole()).toBe(false);
		requested = [];
		await filled("1", first);
		expect(requested.map((each) => each.path)).toContain(path);
		expect(await stored.isWhole()).toBe(true);
	});

	it("takes nothing of another build for its own", async () => {
		host = second;
		const stored = app("1", first);
		await expect(stored.fill()).rejects.toThrow();
		expect(await stored.isWhole()).toBe(false);
	});

	it("fetches once, however many pages ask at once, and nothing that is there", async () => {
		host = first;
		const stored = app("1", first);
		await Promise.all([stored.fill(), stored.fill()]);
		await stored.fill();
		expect(requested).toHaveLength(4);
	});

	it("brings a file alone, and keeps it", async () => {
		host = first;
		const stored = app("1", first);
		expect(await text(stored.bring("assets/a-1.js"))).toBe("a 1");
		expect(await text(stored.bring("assets/a-1.js"))).toBe("a 1");
		expect(requested).toHaveLength(1);
		expect(await stored.isWhole()).toBe(false);
	});

	it("can be opened where the host sent its page on from another address", async () => {
		const answer = new Response("page 1");
		Object.defineProperty(answer, "redirected", { value: true });
		const built = { release: "1", id: "1", files: { "": "page 1" }, cores: {}, specimens: "" };
		const options = { scope, built, caches: caches as unknown as CacheStorage, fetch: async () => answer };
		const stored = new CachedApp(options);
		await stored.fill();
		expect(await text(stored.find(""))).toBe("page 1");
		expect(caches.stored.get(`panicle ${scope} 1`)?.get(scope)?.redirected).toBe(false);
	});
});

describe("two builds", () => {
	it("stand side by side: a page of the old one finds what only that has", async () => {
		await filled("1", first);
		requested = [];
		const next = await filled("2", second);
		expect(requested.map(({ path }) => path).sort()).toEqual(["", "assets/a-2.js", "icons/one.svg"]);
		expect(await next.isOtherWhole()).toBe(true);
		expect(await text(next.find("assets/a-1.js"))).toBe("a 1");
		expect(await text(next.find(""))).toBe("page 2");
	});

	it("are one again when no page of the old one is open", async () => {
		await filled("1", first);
		const next = await filled("2", second);
		await next.sweep([`${scope}assets/a-2.js`, `${scope}assets/a-1.js`]);
		expect([...caches.stored.keys()]).toHaveLength(2);
		await next.sweep([`${scope}assets/a-2.js`]);
		expect([...caches.stored.keys()]).toEqual([`panicle ${scope} 2`]);
		expect(await next.isOtherWhole()).toBe(false);
	});

	it("in two folders of a host leave each other alone, and what is the host’s own", async () => {
		await filled("1", first, `${scope}old/`);
		await caches.open("the host’s own");
		const stored = await filled("2", second);
		expect(await stored.isOtherWhole()).toBe(false);
		await stored.sweep([]);
		expect([...caches.stored.keys()]).toHaveLength(3);
	});
});
