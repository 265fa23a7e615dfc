/**
 * From wasm-core/grammars/<model>/*.lsys: the texts as the web sends them, a constant each, so that only those used are
 * loaded.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder } from "../repository.mjs";
import { isGrown } from "./texts.mjs";

const grammars = join(coreFolder, "grammars");

/** `grape-bunch-3.lsys` → `GRAPE_BUNCH_3`. */
const constantOf = (file) =>
	file
		.replace(/\.lsys$/, "")
		.replaceAll("-", "_")
		.toUpperCase();

function constant(model, file) {
	const text = readFileSync(join(grammars, model, file), "utf8");
	return `/** wasm-core/grammars/${model}/${file} */\nexport const ${constantOf(file)} = ${literal(text)};\n`;
}

/** As a template, so that the text reads as it does in its file. */
const literal = (text) => `\`${text.replace(/[\\`]|\$\{/g, "\\$&")}\``;

/** Returns the generated files. */
export function outputs() {
	return readdirSync(grammars)
		.filter((model) => existsSync(join(coreFolder, "src/models", model)) && !isGrown(model))
		.sort()
		.map((model) => {
			const files = readdirSync(join(grammars, model))
				.filter((file) => file.endsWith(".lsys"))
				.sort();
			const notice = `// Made from wasm-core/grammars/${model} by wasm-core/tools/generate.mjs; edit the texts, not this.\n`;
			return {
				path: `web/src/models/${model}/grammars.generated.ts`,
				text: `${notice}\n${files.map((file) => constant(model, file)).join("\n")}`,
			};
		});
}
