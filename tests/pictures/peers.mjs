/**
 * `npm run pictures -- peers [SPECIES …]`: trees of Panicle, of ez-tree and of three.js' TreeGenerator in one scene with
 * sun and ground, from far and near, in build/peers/. For a judgement that does not depend on the name, each species'
 * sheet shows the three in a random order; build/peers/order.json names them.
 */
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";
import { openSources } from "./sources_page.mjs";

const SIZE = { width: 900, pixels: 1000 };

/** The nearest of ez-tree's presets, settings of the generator, the colour of its leaves, and the tree's height in metres. */
const SPECIES = {
	oak: { height: 15, ezTree: "Oak Large", leaf: "#4a6a30", generator: { levels: 5, children: [6, 8, 6, 4] } },
	birch: { height: 17, ezTree: "Aspen Large", leaf: "#6a8c42", generator: { levels: 4, droop: 0.3, trunkRadius: 0.2 } },
	pine: { height: 20, ezTree: "Pine Large", leaf: "#3f5a38", generator: { levels: 4, trunkClear: 0.55 } },
	cherry: { height: 8, ezTree: "Ash Medium", leaf: "#f0cfd8", generator: { levels: 5, children: [5, 8, 6, 4] } },
	willow: { height: 14, ezTree: "Ash Large", leaf: "#8a9a5a", generator: { levels: 4, droop: 0.9, upPull: 0 } },
	maple: { height: 16, ezTree: "Ash Large", leaf: "#4b6b31", generator: { levels: 5, children: [6, 8, 6, 4] } },
	spruce: {
		height: 22,
		ezTree: "Pine Medium",
		leaf: "#2f4a30",
		generator: { levels: 3, children: [60, 12], branchAngle: [85, 50], trunkClear: 0.05 },
	},
	apple: {
		height: 5,
		ezTree: "Ash Small",
		leaf: "#5a7a3c",
		generator: { levels: 5, children: [5, 8, 6, 4], trunkClear: 0.3 },
	},
	olive: { height: 7, ezTree: "Oak Small", leaf: "#7f8d70", generator: { levels: 5, children: [5, 8, 6, 4] } },
};

/** Grows a tree by the command line, and returns the path of its GLB. */
async function grown(folder, species) {
	const glb = join(folder, `${species}.glb`);
	const words = ["wasm-core/tools/grow.mjs", `growth/${species}`, "--out", glb];
	const { status, output } = await run(process.execPath, words, { cwd: repository });
	if (status !== 0) throw new Error(output);
	return glb;
}

/** Runs in the page. */
async function draw({ from, picture }) {
	const { pictureOf } = await import(/* @vite-ignore */ `/@fs${from}`);
	return pictureOf(picture);
}

/** Runs in the page: pictures (base64) side by side, as a PNG. */
async function sheet({ pictures, width, pixels }) {
	const canvas = new OffscreenCanvas(width * pictures.length, pixels);
	const context = canvas.getContext("2d");
	for (const [i, png] of pictures.entries()) {
		const image = await createImageBitmap(new Blob([Uint8Array.fromBase64(png)], { type: "image/png" }));
		context.drawImage(image, i * width, 0);
	}
	const blob = await canvas.convertToBlob({ type: "image/png" });
	return new Uint8Array(await blob.arrayBuffer()).toBase64();
}

/** Returns the indices 0, 1 and 2 in a random order. */
const shuffled = () => [0, 1, 2].sort(() => Math.random() - 0.5);

/** @param {string[]} named species; none: all */
export async function render(named) {
	const folder = join(buildFolder, "peers");
	mkdirSync(folder, { recursive: true });
	const sources = await openSources();
	const from = join(repository, "tests/pictures/peers_view.ts");
	const order = {};
	for (const species of named.length > 0 ? named : Object.keys(SPECIES)) {
		const { height, ezTree, generator, leaf } = SPECIES[species];
		const seed = 7;
		const glb = await grown(folder, species);
		const makers = [
			{ name: "Panicle", source: { glb: `/@fs${glb}` } },
			{ name: "ez-tree", source: { ezTree, seed } },
			{ name: "TreeGenerator", source: { generator, leaf, seed } },
		];
		order[species] = {};
		for (const near of [false, true]) {
			const places = shuffled();
			const pictures = [];
			for (const i of places) {
				// A page of its own each: a page keeps few WebGL contexts.
				const page = await sources.page({ bypassCSP: true });
				const picture = { source: makers[i].source, height, near, ...SIZE };
				pictures.push(await page.evaluate(draw, { from, picture }));
				if (pictures.length === places.length) {
					const name = `${species}-${near ? "near" : "far"}.png`;
					writeFileSync(join(folder, name), Buffer.from(await page.evaluate(sheet, { pictures, ...SIZE }), "base64"));
					console.log(`build/peers/${name}`);
				}
				await page.close();
			}
			order[species][near ? "near" : "far"] = places.map((i) => makers[i].name);
		}
	}
	writeFileSync(join(folder, "order.json"), `${JSON.stringify(order, null, "\t")}\n`);
	await sources.close();
}
