/** Checks the scripts for Unity and Unreal Engine, which cannot be had here, by compilers. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { checksIn } from "./checks.mjs";

const place = (path) => join(repository, path);

/**
 * Compiles the C# of integrations/unity against declarations of Unity's classes, if Mono's compiler is installed, and
 * compares the names that it shares with its shaders.
 * @param {string} folder receives the assembly
 * @returns {Promise<import("./checks.mjs").Check[]>}
 */
export async function checkUnity(folder) {
	const editor = place("integrations/unity/Panicle/Editor");
	const scripts = readdirSync(editor).filter((name) => name.endsWith(".cs"));
	const sources = [place("tests/integrations/unity_declarations.cs"), ...scripts.map((name) => join(editor, name))];
	const words = [
		"-target:library",
		"-warnaserror",
		"-nowarn:0649,0414",
		`-out:${join(folder, "unity.dll")}`,
		...sources,
	];
	const { status, output } = await run("mcs", words, { cwd: repository });
	const compiled =
		status === 127
			? { title: "not compiled: Mono's compiler is not installed (Debian's mono-mcs)", passed: true }
			: { title: "compiles against the declarations of Unity's classes", passed: status === 0, found: output };
	return [compiled, ...sharedNames(editor, scripts)];
}

/** Compares properties and shaders that the C# sets with those that the shaders have. */
function sharedNames(editor, scripts) {
	const code = scripts.map((name) => readFileSync(join(editor, name), "utf8")).join("\n");
	const shaders = ["Tree", "Impostor"].map((name) =>
		readFileSync(place(`integrations/unity/Panicle/Shaders/${name}.shader`), "utf8"),
	);
	const properties = shaders.flatMap((text) =>
		[...text.matchAll(/^\s+(?:\[.*\] )?(_\w+)\("/gm)].map(([, name]) => name),
	);
	const set = [...code.matchAll(/\.Set\w+\("(\w+)"/g)].map(([, name]) => name);
	const unknown = set.filter((name) => !properties.includes(name));
	const found = [...code.matchAll(/Shader\.Find\("([^"]+)"\)/g)].map(([, name]) => name);
	const absent = found.filter((name) => !shaders.some((text) => text.startsWith(`Shader "${name}"`)));
	return [
		{
			title: "sets only properties that the shaders have",
			passed: set.length > 8 && unknown.length === 0,
			found: `${unknown}`,
		},
		{ title: "uses only shaders of the folder", passed: found.length === 2 && absent.length === 0, found: `${absent}` },
	];
}

/**
 * Checks the Python of integrations/unreal.
 * @returns {Promise<import("./checks.mjs").Check[]>}
 */
export async function checkUnreal() {
	const script = place("integrations/unreal/Panicle/import_tree.py");
	const { status, output } = await run("python3", [place("tests/integrations/unreal.py"), script], { cwd: repository });
	return [...checksIn(output), { title: "all checks run", passed: status === 0, found: output.slice(-800) }];
}
