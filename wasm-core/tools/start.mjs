/** `npm start [-- --port N --host NAME]`: sets up what is missing, then serves the app and prints its address. */
import { join } from "node:path";
import { parseArgs } from "node:util";
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

await command(async () => {
	const { port, host } = options();
	await setUp("core");
	const { createServer } = await import("vite");
	const server = await createServer({
		configFile: join(repository, "vite.config.ts"),
		server: { port, host, strictPort: port !== undefined },
	});
	await server.listen();
	server.printUrls();
});
