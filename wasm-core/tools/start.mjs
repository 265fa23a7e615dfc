/**
 * `npm start [-- --port N --host NAME]`: sets up what is missing, serves the app as soon as the bunch's core is built,
 * and prints its address. The other cores are built in the background (vite_plugin.mjs).
 */
import { join } from "node:path";
import { parseArgs } from "node:util";
import { buildCore, CoreBuildError } from "./core.mjs";
import { repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { ToolchainError } from "./toolchain.mjs";

function options() {
	try {
		const { values } = parseArgs({ options: { port: { type: "string" }, host: { type: "string" } } });
		if (values.port && !/^\d+$/.test(values.port)) throw new Error(`--port takes a number, not ${values.port}`);
		return { port: values.port ? Number(values.port) : undefined, host: values.host };
	} catch (error) {
		throw new ToolchainError(`npm start: ${error.message}`);
	}
}

/** The bunch's core, while npm installs the packages. What does not compile is reported once the page is served. */
async function buildFirst() {
	console.error("Building the core of the bunch; the first time this takes a minute or more …");
	try {
		await buildCore("wasm", ["bunch"]);
	} catch (error) {
		if (!(error instanceof CoreBuildError)) throw error;
	}
}

await command(async () => {
	const { port, host } = options();
	await setUp("core", { meanwhile: buildFirst });
	const { createServer } = await import("vite");
	const server = await createServer({
		configFile: join(repository, "vite.config.ts"),
		server: { port, host, strictPort: port !== undefined },
	});
	await server.listen().catch((error) => {
		if (!/already in use/.test(error.message)) throw error;
		throw new ToolchainError(`Port ${port} is in use; \`npm start -- --port N\` takes another.`);
	});
	server.printUrls();
});
