/**
 * `npm run pictures -- NAME`: renders pictures with the app, into the repository (to be looked at and committed) or into
 * build/. Pictures in the repository are made by this script alone. Without a name it prints the list.
 */
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { command, setUp } from "../../wasm-core/tools/setup.mjs";
import { runTask } from "../../wasm-core/tools/tasks.mjs";

/** A task in a module that imports packages: loaded after they are installed and the core is built. */
const inModule = (file) => async (words) => {
	await setUp("core");
	await buildCore();
	const { render } = await import(file);
	await render(words);
};

/** @type {Record<string, import("../../wasm-core/tools/tasks.mjs").Task>} */
export const PICTURES = {
	shots: {
		about: "the built app at desktop and phone size, light and dark, in build/shots/",
		words: "[WORD …]",
		run: inModule("./shots.mjs"),
	},
	gallery: {
		about: "the presets in the app's gallery, as public/gallery/<model>/*.webp",
		words: "[MODEL[/PRESET] …]",
		run: inModule("./gallery.mjs"),
	},
	families: {
		about: "the plants on the home page, one for each family, as public/families/*.webp",
		words: "[FAMILY …]",
		run: inModule("./families.mjs"),
	},
	share: {
		about: "the picture that previews of links show, as public/share.jpg: the home page",
		run: inModule("./share.mjs"),
	},
	"gallery-docs": {
		about: "the bunches of docs/gallery.md from two sides, and the page itself with their measures",
		run: inModule("./gallery_docs.mjs"),
	},
	pages: {
		about: "the pictures of the pages docs/for-*.md, as docs/people/*.jpg",
		run: inModule("./pages.mjs"),
	},
	drawings: {
		about: "the SVG drawings of docs/models: floral diagrams, and veins of leaves with the measures in likeness.md",
		run: inModule("./drawings.mjs"),
	},
	peers: {
		about: "trees beside those of ez-tree and three.js' TreeGenerator, in a random order, in build/peers/",
		words: "[SPECIES …]",
		run: inModule("./peers.mjs"),
	},
	readers: {
		about: "one bunch in the app, three.js, Blender and F3D, as docs/readers/*.webp (Python 3.11, F3D and xvfb-run)",
		words: "[PRESET …]",
		run: inModule("./readers.mjs"),
	},
};

await command(() => runTask("pictures", PICTURES, process.argv.slice(2)));
