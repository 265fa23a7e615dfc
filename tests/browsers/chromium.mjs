/** The system's Chromium with WebGL 2 rendered in software, for scripts that take pictures or measure the page. */
import { chromium } from "@playwright/test";
import { locate } from "../../wasm-core/tools/toolchain.mjs";

const WEBGL_BY_SOFTWARE = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

/** @param {string[]} flags how the browser draws */
export function launch(flags = WEBGL_BY_SOFTWARE) {
	const { found } = locate(["chromium"]);
	const args = process.getuid?.() === 0 ? [...flags, "--no-sandbox"] : flags;
	return chromium.launch({ executablePath: found.chromium, args });
}
