/** The documentation lists the scripts of package.json, the set-up files and the tools that they install. */
import { readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { describe, expect, it } from "vitest";
import { filesIn } from "../../wasm-core/tools/fresh.mjs";
import { capture } from "../../wasm-core/tools/process.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { tools } from "../../wasm-core/tools/toolchain.mjs";

const read = (file: string) => readFileSync(join(repository, file), "utf8");
const { scripts, engines, bin } = JSON.parse(read("package.json"));

/** Files that may name scripts. Releases of the past in CHANGELOG.md name scripts of their time. */
const texts = filesIn(
	"README.md",
	"CONTRIBUTING.md",
	"SECURITY.md",
	"Containerfile",
	".github",
	"docs",
	"tests",
	"wasm-core",
	"web",
)
	.filter((file) => /\.(md|ts|mjs|yml|cpp|hpp|html|css)$|Containerfile$/.test(file))
	.map((file) => ({ file: relative(repository, file), text: readFileSync(file, "utf8") }));

/** Each call of a script in the texts: its name, and the word after `--` where there is one. */
function calls(pattern: RegExp) {
	return texts.flatMap(({ file, text }) =>
		[...text.matchAll(pattern)].map(([call, ...words]) => ({ file, call, words })),
	);
}

describe("scripts of package.json", () => {
	it("each have a row in the tables of README.md or CONTRIBUTING.md", () => {
		const rows = `${read("README.md")}\n${read("CONTRIBUTING.md")}`
			.split("\n")
			.filter((line) => line.startsWith("| `"));
		const titles = rows.map((row) => row.split("|")[1]).join("\n");
		const described = new Set([...titles.matchAll(/`npm (?:run (?:-s )?)?([a-z][\w:-]*)/g)].map(([, name]) => name));
		expect(Object.keys(scripts).filter((name) => !described.has(name))).toEqual([]);
	});

	it("exist wherever a text names one", () => {
		const named = calls(/npm run (?:-s )?([a-z][\w:-]*)/g);
		expect(named.length).toBeGreaterThan(100);
		expect(named.filter(({ words: [name] }) => !(name in scripts)).map(({ file, call }) => `${file}: ${call}`)).toEqual(
			[],
		);
	});

	it("run a file that exists, and dev is start", () => {
		for (const command of Object.values<string>(scripts)) {
			const file = /^node (\S+)/.exec(command)?.[1];
			if (file) expect(read(file)).not.toBe("");
		}
		expect(scripts.dev).toBe(scripts.start);
	});

	it.each(["pictures", "bench", "docs", "generate"])("%s has each task that a text names, and lists them", (script) => {
		const file = scripts[script].replace("node ", "");
		const list = capture(process.execPath, [join(repository, file), "--help"]) ?? "";
		const tasks = [...list.matchAll(/^ {2}([a-z][\w-]*)/gm)].map(([, name]) => name);
		expect(tasks.length).toBeGreaterThan(1);
		const named = calls(new RegExp(`npm run ${script} -- ([a-z][\\w-]*)`, "g"));
		expect(named.length).toBeGreaterThan(0);
		expect(
			named.filter(({ words: [name] }) => !tasks.includes(name)).map(({ file, call }) => `${file}: ${call}`),
		).toEqual([]);
	});
});

describe("the command `panicle`", () => {
	it("is the script `grow`, and begins as a program of Node", () => {
		expect(`node ${bin.panicle}`).toBe(scripts.grow);
		expect(read(bin.panicle)).toMatch(/^#!\/usr\/bin\/env node\n/);
	});
});

describe("set-up files", () => {
	it("use the oldest Node that is supported", () => {
		expect(`>=${read(".nvmrc").trim()}`).toBe(engines.node);
		expect(read("wasm-core/tools/setup.mjs")).toContain(`"${read(".nvmrc").trim()}"`);
	});

	it("install Debian's packages of every tool in the development container", () => {
		const container = read(".devcontainer/Containerfile");
		const wanted = Object.values(tools).flatMap(({ packages }) => packages["apt-get"]);
		const browsers = [...read("tests/browsers/browsers.mjs").matchAll(/packages: \[([^\]]*)\]/g)]
			.flatMap(([, names]) => [...names.matchAll(/"([^"]+)"/g)])
			.map(([, name]) => name);
		expect(browsers.length).toBeGreaterThan(2);
		const missing = [...wanted, ...browsers].filter(
			(name) => !new RegExp(`^\\s+${name.replaceAll("+", "\\+")} \\\\$`, "m").test(container),
		);
		expect(missing).toEqual([]);
	});
});
