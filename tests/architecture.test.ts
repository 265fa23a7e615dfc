import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { dirname, join, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { generatedFiles } from "../wasm-core/tools/generate/files.mjs";
import { beforeModels, coreModelUses, coreRooms, knowBuild, webModelUses, webRooms } from "./rooms";

const repository = dirname(dirname(fileURLToPath(import.meta.url)));

const listed = execFileSync("git", ["ls-files", "--cached", "--others", "--exclude-standard"], {
	cwd: repository,
	encoding: "utf8",
})
	.split("\n")
	.filter(Boolean);

/** Every file of the repository, those not yet committed and generated ones included. */
const files = [...new Set([...listed, ...generatedFiles().map(({ path }) => path)])];

function read(file: string): string {
	try {
		return readFileSync(join(repository, file), "utf8");
	} catch {
		return ""; // deleted, but not yet from the index
	}
}

interface Import {
	from: string;
	to: string;
	typeOnly: boolean;
	/** Not there when the module is: `import()`, an address, a glob. */
	lazy: boolean;
}

/** Imports of a module's text by relative address, globs included, as addresses in the repository without their ending. */
function importsOf(file: string, text: string): Import[] {
	const statement =
		/(?:^|\n)\s*(import|export)\s+(type\s)?(?:[^"';]*?\sfrom\s+)?"([^"]+)"|import\("([^"]+)"\)|new URL\("(\.[^"]+)"|import\.meta\.glob(?:<[^>]+>)?\(\[?"([^"]+)"/g;
	return [...text.matchAll(statement)]
		.map(([, keyword, type, plain, lazy, address, glob]) => ({
			address: plain ?? lazy ?? address ?? glob,
			typeOnly: type !== undefined,
			lazy: keyword === undefined,
		}))
		.filter(({ address }) => address.startsWith("."))
		.map(({ address, typeOnly, lazy }) => ({
			from: file,
			to: posix.join(posix.dirname(file), address.replace(/\?.*$/, "").replace(/\.ts$/, "")),
			typeOnly,
			lazy,
		}));
}

/** The room of a path in web/src; of a model, its own: `models/bunch`. */
const webRoomOf = (path: string) => /^web\/src\/(models\/[^/]+(?=\/)|[^/]+)\//.exec(path)?.[1];
const isOfModel = (room: string) => room.startsWith("models/");

/** Whether rooms.ts allows an import. */
function isAllowed({ from, to, typeOnly }: Pick<Import, "from" | "to" | "typeOnly">): boolean {
	const [room, other] = [webRoomOf(from), webRoomOf(to)];
	if (to.startsWith("build/")) return room !== undefined && knowBuild.includes(room);
	if (!room || !other || room === other) return true;
	// Models are found by the index, and one may be built on another's folder.
	if (isOfModel(other)) return from === "web/src/models/index.ts" || `models/${webModelUses[room.slice(7)]}` === other;
	// A model's folder sees the interfaces alone.
	if (isOfModel(room))
		return other === "models" ? typeOnly && /^web\/src\/models\/(page_)?model$/.test(to) : beforeModels.includes(other);
	// The interface of a model does not know the page; it imports only types from the page's part.
	if (from === "web/src/models/model.ts")
		return typeOnly && !["ui", "render", "grammar_editor", "import"].includes(other);
	return webRooms[room]?.includes(other) ?? false;
}

/** Circles of modules that import one another, types included. */
function circlesOf(imports: readonly Import[]): string[][] {
	const targets = new Map<string, string[]>();
	for (const { from, to } of imports) {
		const file = [`${to}.ts`, to].find((each) => files.includes(each));
		if (file) targets.set(from, [...(targets.get(from) ?? []), file]);
	}
	const done = new Set<string>();
	const circles: string[][] = [];
	const visit = (file: string, path: string[]): void => {
		const at = path.indexOf(file);
		if (at >= 0) circles.push([...path.slice(at), file]);
		if (at >= 0 || done.has(file)) return;
		for (const next of targets.get(file) ?? []) visit(next, [...path, file]);
		done.add(file);
	};
	for (const file of targets.keys()) visit(file, []);
	return circles;
}

/** Packages that a module comes with: those of everything it imports but lazily. */
function packagesOf(module: string, seen = new Set<string>()): string[] {
	const file = [`${module}.ts`, module].find((each) => files.includes(each));
	if (!file?.endsWith(".ts") || seen.has(file)) return [];
	seen.add(file);
	const text = read(file);
	const own = [...text.matchAll(/(?:^|\n)import (?!type)[^"';]*?(?:from )?"([^."][^"]*)"/g)].map(([, name]) => name);
	const further = importsOf(file, text).filter(({ lazy, typeOnly }) => !lazy && !typeOnly);
	return [...own, ...further.flatMap(({ to }) => packagesOf(to, seen))];
}

describe("the arrow between the rooms", () => {
	it.each(Object.keys(coreRooms))("wasm-core/src/%s includes only folders that it may", (room) => {
		const known = [room, ...(coreRooms[room] as string[])];
		const against = files
			.filter((file) => file.startsWith(`wasm-core/src/${room}/`))
			.flatMap((file) =>
				[...read(file).matchAll(/#include "(([^/"]+)\/[^"]+)"/g)].map(([, path, other]) => ({ file, path, other })),
			)
			.filter(({ other }) => !known.includes(other));
		expect(against).toEqual([]);
	});

	it("has CMake link each folder of the core to those that it may include", () => {
		const lines = [...read("wasm-core/CMakeLists.txt").matchAll(/^panicle_room\(([^)]*)\)$/gm)];
		const linked = lines.map(([, words]) => words.split(" ")).map(([room, ...uses]) => [room, uses] as const);
		expect(Object.fromEntries(linked)).toEqual(coreRooms);
	});

	/** Includes of one model's files by another's, as `from to`. */
	const betweenModels = (file: string, text: string) => {
		const own = /^wasm-core\/src\/models\/([^/]+)\//.exec(file)?.[1];
		const others = [...text.matchAll(/#include "models\/([^/"]+)\//g)].map(([, other]) => other);
		return own === undefined
			? []
			: others.filter((other) => other !== own && other !== coreModelUses[own]).map((other) => `${own} ${other}`);
	};

	it("lets no model of the core include another", () => {
		expect(betweenModels("wasm-core/src/models/leaf/leaf.cpp", '#include "models/bunch/plan.hpp"')).toEqual([
			"leaf bunch",
		]);
		expect(betweenModels("wasm-core/src/models/leaf/leaf.cpp", '#include "models/leaf/vein.hpp"')).toEqual([]);
		expect(files.flatMap((file) => betweenModels(file, read(file)))).toEqual([]);
	});

	/** Words of the one model there is, in code and messages; comments may take it as an example. */
	const words = /berr(?:y|ies)|pedicel|rachis|grape(?!s\b)|(?<!first-)bunch/i;
	const withoutComments = (text: string) => text.replace(/\/\*[\s\S]*?\*\/|(?<![:"'])\/\/.*$/gm, "");

	it("keeps models' words out of the rooms that all share", () => {
		const shared = /^(?:wasm-core\/src\/(?!models\/)|web\/src\/(?!models\/[^/]+\/))[^.]+\.(?:cpp|hpp|h|ts)$/;
		const naming = files
			.filter((file) => shared.test(file))
			.flatMap((file) =>
				withoutComments(read(file))
					.split("\n")
					.filter((line) => words.test(line))
					.map((line) => `${file}: ${line.trim()}`),
			);
		expect(words.test(withoutComments("// a berry\nconst berry = 1;"))).toBe(true);
		expect(words.test(withoutComments("/* a bunch */ const plant = 1; // of grapes"))).toBe(false);
		// The table of families names the plants that they open with; the other line is the default of links.
		const others = naming.filter((line) => !line.startsWith("web/src/app/home/families.ts:"));
		expect(others).toEqual(['web/src/models/index.ts: export const DEFAULT_MODEL = "bunch";']);
	});

	it("knows every room", () => {
		const rooms = (prefix: RegExp) => new Set(files.map((file) => prefix.exec(file)?.[1]).filter(Boolean));
		const ofCore = [...Object.keys(coreRooms), "models", "exports"];
		expect([...rooms(/^wasm-core\/src\/([^/]+)\//)].filter((room) => !ofCore.includes(room!))).toEqual([]);
		expect([...rooms(/^web\/src\/([^/]+)\//)].filter((room) => !(room! in webRooms))).toEqual([]);
	});

	it.each(Object.keys(webRooms))("web/src/%s imports only what it may", (room) => {
		const against = files
			.filter((file) => file.startsWith(`web/src/${room}/`) && file.endsWith(".ts"))
			.flatMap((file) => importsOf(file, read(file)))
			.filter((found) => !isAllowed(found));
		expect(against).toEqual([]);
	});

	it.each(files.filter((file) => /^web\/src\/models\/(?:[^/]+\/){1,2}index\.ts$/.test(file)))(
		"%s comes without Lit and three",
		(file) => {
			expect(packagesOf(file).filter((name) => /^(lit|three)\b/.test(name))).toEqual([]);
		},
	);

	it("has no circle of imports, types included", () => {
		const modules = files.filter((file) => /^web\/src\/.*\.ts$/.test(file));
		expect(circlesOf(modules.flatMap((file) => importsOf(file, read(file)).filter(({ lazy }) => !lazy)))).toEqual([]);
		const between = (from: string, to: string) => ({ from, to, typeOnly: true, lazy: false });
		const [one, other] = ["web/src/core/core.ts", "web/src/core/pool.ts"];
		expect(circlesOf([between(one, "web/src/core/pool"), between(other, "web/src/core/core")])).toEqual([
			[one, other, one],
		]);
	});

	it("sees imports of every form", () => {
		const text = [
			'import { a } from "../render/a";',
			'import type {\n\tB,\n} from "../app/b.ts";',
			'import "./side";',
			'const c = await import("../formats/c");',
			'new Worker(new URL("../core/worker.ts", import.meta.url));',
			'import.meta.glob<Model>("../models/*/index.ts", { import: "model" });',
			'import { LitElement } from "lit";',
		].join("\n");
		const found = (to: string, typeOnly = false, lazy = false) => ({ from: "web/src/core/x.ts", to, typeOnly, lazy });
		expect(importsOf("web/src/core/x.ts", text)).toEqual([
			found("web/src/render/a"),
			found("web/src/app/b", true),
			found("web/src/core/side"),
			found("web/src/formats/c", false, true),
			found("web/src/core/worker", false, true),
			found("web/src/models/*/index", false, true),
		]);
	});

	it("lets workers come without Lit and three", () => {
		for (const worker of [
			"web/src/core/worker",
			"web/src/generate/files/file_worker",
			"web/src/import/mesh_file/mesh_worker",
		]) {
			expect(packagesOf(worker).filter((name) => /^(lit|three)\b/.test(name))).toEqual([]);
		}
	});

	it("sees what a module comes with", () => {
		expect(packagesOf("web/src/models/bunch/ui/ui")).toEqual(expect.arrayContaining(["lit"]));
		expect(packagesOf("web/src/render/viewer")).toContain("three");
		expect(packagesOf("web/src/specimen/link")).toEqual([]);
	});

	it.each([
		["core/x.ts", "specimen/link", false],
		["core/x.ts", "specimen/specimen", true],
		["render/x.ts", "models/bunch/bunch_plant", true],
		["app/x.ts", "models/bunch/index", false],
		["models/leaf/index.ts", "models/bunch/bunch_plant", true],
		["models/leaf/index.ts", "models/index", false],
		["models/leaf/index.ts", "app/studio", true],
		["models/model.ts", "ui/tool", false],
		["ui/x.ts", "app/studio", true],
		["specimen/x.ts", "plant/plant", true],
	])("refuses what goes against it: %s → %s", (from, to, typeOnly) => {
		expect(isAllowed({ from: `web/src/${from}`, to: `web/src/${to}`, typeOnly })).toBe(false);
	});

	it.each([
		["models/index.ts", "models/*/index", false],
		["models/leaf/index.ts", "models/model", true],
		["models/leaf/index.ts", "ui/life", false],
		["models/page_model.ts", "render/model_renderer", true],
		["models/leaf/index.ts", "models/particles/record", false],
		["app/x.ts", "models/index", false],
	])("allows what goes with it: %s → %s", (from, to, typeOnly) => {
		expect(isAllowed({ from: `web/src/${from}`, to: `web/src/${to}`, typeOnly })).toBe(true);
	});

	it("lets only rooms that know the build import the core's files", () => {
		expect(isAllowed({ from: "web/src/render/x.ts", to: "build/core/bunch.wasm", typeOnly: false })).toBe(false);
		expect(isAllowed({ from: "web/src/app/x.ts", to: "build/core/bunch.wasm", typeOnly: false })).toBe(true);
	});
});

describe("the repository", () => {
	const isText = (file: string) => !/\.(png|jpe?g|webp|ktx2|hdr|bin|woff2|glb|wasm|ico)$/.test(file);

	it("names no place of one machine", () => {
		const places = /(?<![\w.:/-])\/(?:work|home|root|Users|mnt|srv)\/[\w.-]+/;
		const naming = files.filter((file) => isText(file) && file !== "package-lock.json" && places.test(read(file)));
		expect(naming).toEqual([]);
	});
});
