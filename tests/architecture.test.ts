import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";

const repository = dirname(dirname(fileURLToPath(import.meta.url)));

/** Every file of the repository, those not yet committed included. */
const files = execFileSync("git", ["ls-files", "--cached", "--others", "--exclude-standard"], {
	cwd: repository,
	encoding: "utf8",
})
	.split("\n")
	.filter(Boolean);

function read(file: string): string {
	try {
		return readFileSync(join(repository, file), "utf8");
	} catch {
		return ""; // deleted, but not yet from the index
	}
}

const coreRooms = ["foundation", "geometry", "environment", "lsystem", "models", "boundary"];

/** What each room of web/src may import besides itself; `element` is a room to come. */
const webRooms: Record<string, string[]> = {
	core: [],
	specimen: ["core"],
	scene: ["core", "specimen"],
	profile: ["core", "specimen"],
	export: ["core", "specimen"],
	element: ["core", "specimen", "scene", "profile", "export"],
	studio: ["core", "specimen", "scene", "profile", "export", "element"],
	cli: ["core", "specimen", "export"],
};

/** What the room `core` may know of the one after it: its tables of ranges, and the specimen as a type. */
const tablesOfSpecimen = ["parameters.generated", "table", "limits"].map((name) => `web/src/specimen/${name}`);
/** Rooms that say where the built core lies; the others get it from them. */
const knowBuild = ["core", "element", "studio", "cli"];

interface Import {
	from: string;
	to: string;
	typeOnly: boolean;
}

/** Imports of a module's text by relative address, as addresses in the repository without their ending. */
function importsOf(file: string, text: string): Import[] {
	const statement =
		/(?:^|\n)\s*(import|export)\s+(type\s)?(?:[^"';]*?\sfrom\s+)?"([^"]+)"|import\("([^"]+)"\)|new URL\("(\.[^"]+)"/g;
	return [...text.matchAll(statement)]
		.map(([, , type, plain, lazy, address]) => ({ address: plain ?? lazy ?? address, typeOnly: type !== undefined }))
		.filter(({ address }) => address.startsWith("."))
		.map(({ address, typeOnly }) => ({
			from: file,
			to: posix.join(posix.dirname(file), address.replace(/\?.*$/, "").replace(/\.ts$/, "")),
			typeOnly,
		}));
}

const webRoomOf = (path: string) => /^web\/src\/([^/]+)\//.exec(path)?.[1];

/** Whether the arrow allows an import. */
function isAllowed({ from, to, typeOnly }: Import): boolean {
	const [room, other] = [webRoomOf(from), webRoomOf(to)];
	if (to.startsWith("build/")) return room !== undefined && knowBuild.includes(room);
	if (!room || !other || room === other) return true;
	if (room === "core" && other === "specimen") return typeOnly || tablesOfSpecimen.includes(to);
	return webRooms[room]?.includes(other) ?? false;
}

describe("the arrow between the rooms", () => {
	it.each(coreRooms)("wasm-core/src/%s includes only rooms before it", (room) => {
		const known = coreRooms.slice(0, coreRooms.indexOf(room) + 1);
		const against = files
			.filter((file) => file.startsWith(`wasm-core/src/${room}/`))
			.flatMap((file) =>
				[...read(file).matchAll(/#include "(([^/"]+)\/[^"]+)"/g)].map(([, path, other]) => ({ file, path, other })),
			)
			.filter(({ other }) => !known.includes(other));
		expect(against).toEqual([]);
	});

	it("knows every room", () => {
		const rooms = (prefix: RegExp) => new Set(files.map((file) => prefix.exec(file)?.[1]).filter(Boolean));
		expect([...rooms(/^wasm-core\/src\/([^/]+)\//)].filter((room) => !coreRooms.includes(room!))).toEqual([]);
		expect([...rooms(/^web\/src\/([^/]+)\//)].filter((room) => !(room! in webRooms))).toEqual([]);
	});

	it.each(Object.keys(webRooms))("web/src/%s imports only what it may", (room) => {
		const against = files
			.filter((file) => file.startsWith(`web/src/${room}/`) && file.endsWith(".ts"))
			.flatMap((file) => importsOf(file, read(file)))
			.filter((found) => !isAllowed(found));
		expect(against).toEqual([]);
	});

	it("sees imports of every form", () => {
		const text = [
			'import { a } from "../scene/a";',
			'import type {\n\tB,\n} from "../studio/b.ts";',
			'import "./side";',
			'const c = await import("../export/c");',
			'new Worker(new URL("../core/worker.ts", import.meta.url));',
			'import { LitElement } from "lit";',
		].join("\n");
		expect(importsOf("web/src/core/x.ts", text)).toEqual([
			{ from: "web/src/core/x.ts", to: "web/src/scene/a", typeOnly: false },
			{ from: "web/src/core/x.ts", to: "web/src/studio/b", typeOnly: true },
			{ from: "web/src/core/x.ts", to: "web/src/core/side", typeOnly: false },
			{ from: "web/src/core/x.ts", to: "web/src/export/c", typeOnly: false },
			{ from: "web/src/core/x.ts", to: "web/src/core/worker", typeOnly: false },
		]);
	});

	it("refuses what goes against it", () => {
		const core = (to: string, typeOnly = false) => isAllowed({ from: "web/src/core/x.ts", to, typeOnly });
		expect(core("web/src/specimen/link")).toBe(false);
		expect(core("web/src/specimen/specimen", true)).toBe(true);
		expect(core(tablesOfSpecimen[0])).toBe(true);
		expect(isAllowed({ from: "web/src/scene/x.ts", to: "build/core/bunch.wasm", typeOnly: false })).toBe(false);
	});
});

describe("the repository", () => {
	const isText = (file: string) => !/\.(png|jpe?g|webp|ktx2|hdr|bin|woff2|glb|wasm|ico)$/.test(file);

	it("names no place of one machine", () => {
		const places = /(?<![\w.:/-])\/(?:work|home|root|Users|mnt|srv)\/[\w.-]+/;
		const naming = files.filter((file) => isText(file) && file !== "package-lock.json" && places.test(read(file)));
		expect(naming).toEqual([]);
	});

	/** Addresses of links and pictures, less those of the web and places in the same page. */
	const linksIn = (text: string) =>
		[...text.matchAll(/\]\(([^)\s]+)(?:\s"[^"]*")?\)|(?:src|href)="([^"]+)"/g)]
			.map(([, written, tag]) => (written ?? tag).replace(/#.*$/, ""))
			.filter((address) => address !== "" && !/^[a-z]+:/i.test(address));

	it("links only to files that are there", () => {
		expect(linksIn('[a](b.md#c) [d](https://e.f/) [g](#h) ![i](j/k.png "l") <img src="m.webp">')).toEqual([
			"b.md",
			"j/k.png",
			"m.webp",
		]);
		const broken = files
			.filter((file) => file.endsWith(".md"))
			.flatMap((file) => linksIn(read(file)).map((address) => ({ file, address })))
			.filter(({ file, address }) => !existsSync(join(repository, dirname(file), address)));
		expect(broken).toEqual([]);
	});

	it.each([
		[/^(web\/src|tests|wasm-core\/tools)\/.*\.(ts|mjs)$/, 300],
		[/^(wasm-core|tests)\/.*\.(cpp|hpp|h)$/, 600],
	])("keeps files like %s within %i lines", (pattern, limit) => {
		const long = files
			.filter((file) => pattern.test(file) && !file.includes(".generated."))
			.map((file) => ({ file, lines: read(file).split("\n").length - 1 }))
			.filter(({ lines }) => lines > limit);
		expect(long).toEqual([]);
	});
});
