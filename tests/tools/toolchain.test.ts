import { chmodSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { isInstalled } from "../../wasm-core/tools/npm_packages.mjs";
import { isOlder, objections } from "../../wasm-core/tools/packages.mjs";
import {
	emscriptenWarning,
	findEmscripten,
	findHeader,
	findProgram,
	locate,
	missingMessage,
	needs,
	prepare,
	ToolchainError,
	tools,
} from "../../wasm-core/tools/toolchain.mjs";

let machine: string;

beforeEach(() => {
	machine = mkdtempSync(join(tmpdir(), "toolchain-"));
});
afterEach(() => rmSync(machine, { recursive: true }));

/** Puts a program on the pretended machine and returns its folder. */
function program(path: string, text = "#!/bin/sh\n"): string {
	const file = join(machine, path);
	mkdirSync(dirname(file), { recursive: true });
	writeFileSync(file, text);
	chmodSync(file, 0o755);
	return dirname(file);
}

function emscripten(folder: string, version: string): string {
	program(`${folder}/emcc`);
	writeFileSync(join(machine, folder, "emscripten-version.txt"), `"${version}"\n`);
	return join(machine, folder);
}

describe("finding programs and headers", () => {
	it("takes the first name and the first place", () => {
		const [a, b] = [program("a/ninja-build"), program("b/ninja")];
		const env = { PATH: [a, b].join(delimiter) };
		expect(findProgram(["ninja", "ninja-build"], env)).toBe(join(b, "ninja"));
		expect(findProgram(["samu"], env)).toBeNull();
	});

	it("passes over what cannot be run", () => {
		const folder = program("a/cmake");
		chmodSync(join(folder, "cmake"), 0o644);
		mkdirSync(join(machine, "b/cmake"), { recursive: true });
		expect(findProgram(["cmake"], { PATH: [folder, join(machine, "b")].join(delimiter) })).toBeNull();
	});

	it("finds headers where CPATH says before where they usually are", () => {
		const usual = dirname(program("usual/glm/glm.hpp"));
		const named = dirname(program("named/glm/glm.hpp"));
		expect(findHeader("glm/glm.hpp", {}, [usual])).toBe(usual);
		expect(findHeader("glm/glm.hpp", { CPATH: named }, [usual])).toBe(named);
	});
});

describe("finding Python", () => {
	it("skips one that makes no environments, as Debian's is without a further package, and names that package", () => {
		const bare = program("bare/python3", "#!/bin/sh\nexit 1\n");
		expect(tools.python.find({ PATH: bare })).toBeNull();
		const whole = program("whole/python3");
		expect(tools.python.find({ PATH: whole })).toBe(join(whole, "python3"));
		expect(tools.python.find({ PATH: bare, PYTHON: join(whole, "python3") })).toBe(join(whole, "python3"));
		const apt = { name: "apt-get", commands: (packages: string[]) => [`apt-get install ${packages.join(" ")}`] };
		const { missing } = locate(needs.trimesh, { PATH: bare });
		expect(missingMessage(missing, apt, "which is not there")).toMatch(/^ {2}apt-get install .*\bpython3-venv\b/m);
		expect(locate(needs.trimesh, { PATH: whole }).found).toEqual({ python: join(whole, "python3") });
	});
});

describe("finding Emscripten", () => {
	it("takes one on PATH before that of EMSDK", () => {
		const path = emscripten("bin", "3.1.6");
		emscripten("sdk/upstream/emscripten", "4.0.10");
		expect(findEmscripten({ PATH: path, EMSDK: join(machine, "sdk") }, [])).toBe(join(path, "emcc"));
	});

	it("passes over one that is too old", () => {
		const old = emscripten("bin", "2.0.34");
		const sdk = emscripten("sdk/upstream/emscripten", "4.0.10");
		expect(findEmscripten({ PATH: old }, [])).toBeNull();
		expect(findEmscripten({ PATH: old, EMSDK: join(machine, "sdk") }, [])).toBe(join(sdk, "emcc"));
	});

	it("reads the version beside the program that a link leads to, and asks a wrapper for it", () => {
		emscripten("share/emscripten", "3.1.69");
		mkdirSync(join(machine, "bin"));
		symlinkSync(join(machine, "share/emscripten/emcc"), join(machine, "bin/emcc"));
		expect(findEmscripten({ PATH: join(machine, "bin") }, [])).toBe(join(machine, "bin/emcc"));
		const wrapper = program(
			"brew/emcc",
			"#!/bin/sh\necho 'emcc (Emscripten gcc/clang-like replacement) 4.0.2 (abc)'\n",
		);
		expect(findEmscripten({ PATH: wrapper }, [])).toBe(join(wrapper, "emcc"));
	});

	it("warns of a version newer than those tested, and of no other", () => {
		const emcc = (version: string) => join(emscripten(`sdk-${version}`, version), "emcc");
		expect(emscriptenWarning(emcc("3.1.6"))).toBeUndefined();
		expect(emscriptenWarning(emcc("3.1.69"))).toBeUndefined();
		expect(emscriptenWarning(emcc("4.0.10"))).toBe(
			"Emscripten 4.0.10 is newer than those tested (3.1.6 to 3.1.69): sizes and speed may differ.",
		);
	});

	it.each([
		["3.1.6", "3.1.6", false],
		["3.1.6", "3.1.27", true],
		["3.1.69", "3.1.6", false],
		["4.0.0", "3.9.9", false],
		["20.9", "20.19.0", true],
	])("orders versions: %s before %s is %s", (a, b, older) => expect(isOlder(a, b)).toBe(older));
});

describe("what is missing", () => {
	it("is one message with the commands of the machine's package manager", () => {
		const manager = { name: "pacman", commands: (packages: string[]) => [`pacman -S ${packages.join(" ")}`] };
		expect(missingMessage(["emscripten", "glm"], manager, "which this machine does not have")).toBe(
			[
				"Panicle needs Emscripten 3.1.6 or newer (emcc) and GLM, which this machine does not have.",
				"Install them with",
				"  pacman -S emscripten glm",
				"and run the same command again.",
			].join("\n"),
		);
	});

	it("names another way for what the packages do not bring", () => {
		const manager = { name: "apt-get", commands: (packages: string[]) => [`apt-get install ${packages.join(" ")}`] };
		const message = missingMessage(["emscripten", "cmake"], manager, "and so on", ["emscripten"]);
		expect(message).toContain("  apt-get install cmake\n  git clone https://github.com/emscripten-core/emsdk\n");
	});

	it("reads from a dry run which packages apt-get cannot provide", () => {
		const oldest = { emscripten: "3.1.6" };
		const inst = (version: string) => `Inst emscripten (${version}~dfsg-3ubuntu2 Ubuntu:22.04/jammy [all])\n`;
		expect(objections({ status: 0, output: inst("3.1.6") }, oldest)).toBeNull();
		expect(objections({ status: 0, output: inst("3.1.5") }, oldest)).toEqual({
			why: "and this system's packages are too old (emscripten 3.1.5)",
			unfit: ["emscripten"],
		});
		expect(objections({ status: 100, output: "E: Unable to locate package chromium\n" }, oldest)).toEqual({
			why: "and its packages do not install (Unable to locate package chromium)",
			unfit: ["chromium"],
		});
		expect(objections({ status: 100, output: "E: Could not get lock.\n" }, oldest)?.unfit).toEqual([]);
	});

	it("stops a machine without a package manager at once", async () => {
		const env = { PATH: program("empty/nothing") };
		expect(locate(needs.core, env).missing).toContain("cmake");
		await expect(prepare("core", { env })).rejects.toThrow(ToolchainError);
	});

	it("has packages for every tool and manager", () => {
		for (const tool of Object.values(tools)) {
			expect(Object.keys(tool.packages)).toEqual(["apt-get", "dnf", "pacman", "brew"]);
		}
	});

	it("does not ask for the tests' tools to start the app", () => {
		expect(needs.core).toEqual(["emscripten", "glm", "cmake", "ninja"]);
	});
});

describe("npm packages", () => {
	const lock = {
		packages: {
			"": { version: "0.1.0" },
			"node_modules/lit": { version: "3.3.3", integrity: "sha512-a" },
			"node_modules/fsevents": { version: "2.3.3", integrity: "sha512-b", optional: true },
		},
	};
	const { "": _, ...all } = lock.packages;
	const { "node_modules/fsevents": __, ...onLinux } = all;

	it("are installed when npm's record is the lockfile's, less what is for other systems", () => {
		expect(isInstalled(lock, { packages: all })).toBe(true);
		expect(isInstalled(lock, { packages: onLinux })).toBe(true);
	});

	it("are stale with another version, one too few or one too many, and missing without a record", () => {
		const lit = { version: "3.3.2", integrity: "sha512-c" };
		expect(isInstalled(lock, { packages: { ...onLinux, "node_modules/lit": lit } })).toBe(false);
		expect(isInstalled(lock, { packages: {} })).toBe(false);
		expect(isInstalled(lock, { packages: { ...onLinux, "node_modules/three": lit } })).toBe(false);
		expect(isInstalled(lock, null)).toBe(false);
	});
});
