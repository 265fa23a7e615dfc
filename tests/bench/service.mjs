/** `npm run bench -- service`: how many bunches of 120 berries a second of one processor's time the model service answers as JSON. */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { bundleForNode } from "../../wasm-core/tools/node_bundle.mjs";
import { buildFolder, modulesFolder } from "../../wasm-core/tools/repository.mjs";
import { printTable } from "./statistics.mjs";

const BUNCH = "http://localhost/specimens/long-conical.json?count=120";

export async function benchService() {
	const { makeService, loadCoreFromBytes } = await bundled();
	const loadCore = async (wasm) => loadCoreFromBytes(await readFile(join(modulesFolder, wasm)));
	const service = makeService({ release: "bench", loadCore });
	let seed = 0;
	const send = async (address, count) => {
		for (let i = 0; i < count; i++) {
			const answer = await service(new Request(`${address}&seed=${++seed}`));
			if (answer.status !== 200) throw new Error(await answer.text());
			await answer.arrayBuffer();
		}
	};
	const perSecond = async (address, count) => {
		const from = process.cpuUsage();
		await send(address, count);
		const { user, system } = process.cpuUsage(from);
		return (1e6 * count) / (user + system);
	};
	await send(BUNCH, 200);
	const rows = [["JSON", "a second of processor time"]];
	rows.push(["without measures", (await perSecond(`${BUNCH}&file-measures=0`, 300)).toFixed(0)]);
	rows.push(["with measures", (await perSecond(BUNCH, 300)).toFixed(0)]);
	printTable("Bunches of 120 berries, answered by the model service", rows);
}

/** As it runs: models come by lazy imports, which a bundle resolves. */
async function bundled() {
	const folder = join(buildFolder, "node/bench");
	await bundleForNode({ service: "service/service.ts", loader: "core/loader.ts" }, folder);
	const at = (name) => import(pathToFileURL(join(folder, `${name}.mjs`)).href);
	return { ...(await at("service")), ...(await at("loader")) };
}
