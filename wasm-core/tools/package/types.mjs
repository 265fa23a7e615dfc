/**
 * The package's types: the sources' declarations, as TypeScript writes them, bundled into one file for each entry
 * point, with their comments.
 */
import { rmSync } from "node:fs";
import { join } from "node:path";
import { run } from "../process.mjs";
import { buildFolder, repository } from "../repository.mjs";
import { ToolchainError } from "../toolchain.mjs";

/** Entry points by the names of their files, with the sources whose exports they have. */
const DOORS = {
	panicle: "library/index",
	three: "library/three",
	forest: "library/forest/forest",
	element: "element/panicle",
};

const declarations = join(buildFolder, "package/declarations");

/** Messages to ignore: rules of TSDoc that the sources' comments do not follow, and problems of other packages. */
const IGNORED_MESSAGES = ["ae-missing-release-tag", "ae-forgotten-export", "tsdoc-param-tag-missing-hyphen"];

/**
 * Writes a file of types for each entry point into a folder.
 * @returns {Promise<Record<string, string>>} files with the models of the declarations, for pages, by the names of the entry points
 */
export async function writeTypes(folder) {
	rmSync(declarations, { recursive: true, force: true });
	const compiler = join(repository, "node_modules/typescript/bin/tsc");
	const project = join(repository, "wasm-core/tools/package/declarations.json");
	const { status, output } = await run(process.execPath, [compiler, "--project", project]);
	if (status !== 0) throw new ToolchainError(output.trim());
	const { Extractor, ExtractorConfig, ExtractorLogLevel } = await import("@microsoft/api-extractor");
	const models = {};
	for (const [door, source] of Object.entries(DOORS)) {
		models[door] = join(buildFolder, "package", `${door}.api.json`);
		const config = ExtractorConfig.prepare(
			configuration(source, join(folder, `${door}.d.ts`), models[door], ExtractorLogLevel.Warning),
		);
		const problems = [];
		Extractor.invoke(config, {
			localBuild: true,
			messageCallback: (message) => {
				message.handled = true;
				const { messageId, text, logLevel } = message;
				if (["error", "warning"].includes(logLevel) && !IGNORED_MESSAGES.includes(messageId)) problems.push(text);
			},
		});
		if (problems.length > 0) throw new ToolchainError(`${source}.ts:\n${problems.join("\n")}`);
	}
	return models;
}

/**
 * Returns the configuration of API Extractor for an entry point: all messages are reported at `logLevel`.
 * @returns {import("@microsoft/api-extractor").IExtractorConfigPrepareOptions}
 */
function configuration(source, types, model, logLevel) {
	const messageLevels = { default: { logLevel } };
	return {
		configObjectFullPath: undefined,
		packageJsonFullPath: join(repository, "package.json"),
		configObject: {
			projectFolder: repository,
			mainEntryPointFilePath: join(declarations, `web/src/${source}.d.ts`),
			compiler: {
				overrideTsconfig: {
					compilerOptions: {
						target: "es2022",
						lib: ["es2022", "dom", "dom.iterable"],
						module: "esnext",
						moduleResolution: "bundler",
						types: [],
						skipLibCheck: true,
						strict: true,
					},
				},
			},
			apiReport: { enabled: false, reportFileName: "unused" },
			docModel: { enabled: true, apiJsonFilePath: model },
			dtsRollup: { enabled: true, untrimmedFilePath: types },
			tsdocMetadata: { enabled: false },
			newlineKind: "lf",
			messages: {
				compilerMessageReporting: messageLevels,
				extractorMessageReporting: messageLevels,
				tsdocMessageReporting: messageLevels,
			},
		},
	};
}
