/** The system's Chromium with WebGL 2 by software, and the app's own servers, for the scripts that take pictures. */
import { chromium } from "@playwright/test";
import { locate } from "../../wasm-core/tools/toolchain.mjs";

const FLAGS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

export function launch() {
	const { found } = locate(["chromium"]);
	const args = process.getuid?.() === 0 ? [...FLAGS, "--no-sandbox"] : FLAGS;
	return chromium.launch({ executablePath: found.chromium, args });
}
