/**
 * `npm run pictures -- readers [PRESET …]`: the same bunch in the app, in three.js, in Blender and in F3D, side by side, as
 * docs/readers/*.webp. Installs Blender into build/ (tests/readers/programs.mjs). F3D and xvfb-run must be installed
 * (`apt-get install f3d xvfb`); without them F3D's column stays empty. Run it when exported files have changed, and commit the files.
 */
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, modulesFolder, repository } from "../../wasm-core/tools/repository.mjs";
import { installed, must } from "../readers/programs.mjs";
import { openSources } from "./sources_page.mjs";

/** A dark variety, a red one and a pale one. */
const PRESETS = ["merlot", "crimson-seedless", "riesling"];
const SIZE = { width: 360, height: 480 };
/** Blender's wheels are for this one alone. */
const PYTHON = "python3.11";
/** Of the ground that all stand before, as the app has it. */
const GROUND = "#efece6";
const QUALITY = 0.85;

/** Runs in the page, where Vite serves the sources. */
async function inApp({ cores, name, width, height }) {
	const at = (path) => import(/* @vite-ignore */ `/src/${path}`);
	const { Viewer } = await at("render/viewer.ts");
	const { Core } = await at("core/core.ts");
	const { compileCore } = await at("core/loader.ts");
	const { fromPreset } = await at("specimen/from_preset.ts");
	const { modelNamed } = await at("models/index.ts");
	const model = await modelNamed("bunch");
	const core = await Core.instantiate(await compileCore(`/@fs${cores}/${model.wasm}`));
	const specimen = fromPreset(model, name);
	const canvas = Object.assign(document.createElement("canvas"), { width, height });
	const view = new Viewer(canvas, { still: true, reducedMotion: true, theme: "light" });
	view.use(await model.render());
	view.show(model.read(core.grow(model.encode(specimen)), specimen), specimen);
	view.resetView("front");
	const picture = await view.snapshot(2 * width, 2 * height);
	view.dispose();
	return new Uint8Array(await picture.arrayBuffer()).toBase64();
}

/** Runs in the page. */
async function inThree({ from, glb, width, height }) {
	const { pictureOf } = await import(/* @vite-ignore */ `/@fs${from}`);
	const picture = await pictureOf(Uint8Array.fromBase64(glb), 2 * width, 2 * height);
	return new Uint8Array(await picture.arrayBuffer()).toBase64();
}

/** Runs in the page: arranges PNG pictures (base64) with captions side by side as a WebP. */
async function sheet({ pictures, width, height, ground, quality }) {
	const line = 26;
	const canvas = new OffscreenCanvas(width * pictures.length, height + line);
	const context = canvas.getContext("2d");
	context.fillStyle = ground;
	context.fillRect(0, 0, canvas.width, canvas.height);
	context.imageSmoothingQuality = "high";
	context.font = "14px sans-serif";
	context.textAlign = "center";
	context.fillStyle = "#333";
	for (const [i, { label, png }] of pictures.entries()) {
		if (png) {
			const image = await createImageBitmap(new Blob([Uint8Array.fromBase64(png)], { type: "image/png" }));
			context.drawImage(image, i * width, 0, width, height);
		}
		context.fillText(label, (i + 0.5) * width, height + 17);
	}
	const blob = await canvas.convertToBlob({ type: "image/webp", quality });
	return new Uint8Array(await blob.arrayBuffer()).toBase64();
}

/** A program's picture as base64; nothing where it cannot be had. */
async function byProgram(png, command, args) {
	rmSync(png, { force: true });
	const { status, output } = await run(command, args, { cwd: repository });
	if (status === 0 && existsSync(png)) return readFileSync(png).toString("base64");
	console.log(`No picture by ${command}: ${output.slice(-300)}`);
	return undefined;
}

/** F3D stands farther off than the others. */
const CLOSER = ["--camera-view-angle", "20.5"];
const f3dWords = (glb, png, { width, height }) => {
	const resolution = `${2 * width},${2 * height}`;
	const [r, g, b] = [1, 3, 5].map((at) => Number.parseInt(GROUND.slice(at, at + 2), 16) / 255);
	return [
		"-a",
		"f3d",
		"--output",
		png,
		"--resolution",
		resolution,
		"--fxaa",
		"--bg-color",
		`${r},${g},${b}`,
		...CLOSER,
		glb,
	];
};

/** @param {string[]} named presets of bunches; none: three of different colours */
export async function render(named) {
	const python = await installed("readers", PYTHON);
	const folder = join(buildFolder, "readers");
	const out = join(repository, "docs/readers");
	mkdirSync(out, { recursive: true });
	const sources = await openSources();
	// three's loader creates pictures in a way that the page's policy forbids.
	const page = await sources.page({ bypassCSP: true });
	for (const name of named.length > 0 ? named : PRESETS) {
		const path = (ending) => join(folder, `${name}${ending}`);
		const glb = path(".glb");
		await must(process.execPath, ["wasm-core/tools/grow.mjs", name, "--out", glb]);
		const [width, height] = [String(2 * SIZE.width), String(2 * SIZE.height)];
		const render = [join(repository, "tests/pictures/render.py"), glb, path("-blender.png"), width, height];
		const from = join(repository, "tests/pictures/three_view.ts");
		const pictures = [
			{ label: "Panicle", png: await page.evaluate(inApp, { cores: modulesFolder, name, ...SIZE }) },
			{
				label: "three.js, RoomEnvironment",
				png: await page.evaluate(inThree, { from, glb: readFileSync(glb).toString("base64"), ...SIZE }),
			},
			{ label: "Blender, Cycles", png: await byProgram(path("-blender.png"), python, render) },
			{ label: "F3D", png: await byProgram(path("-f3d.png"), "xvfb-run", f3dWords(glb, path("-f3d.png"), SIZE)) },
		];
		const bytes = Buffer.from(
			await page.evaluate(sheet, { pictures, ...SIZE, ground: GROUND, quality: QUALITY }),
			"base64",
		);
		writeFileSync(join(out, `${name}.webp`), bytes);
		console.log(`docs/readers/${name}.webp: ${(bytes.length / 1024).toFixed(0)} kB`);
	}
	await sources.close();
}
