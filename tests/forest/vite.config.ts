import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

/** Builds a page with forests, with all of three.js as in pages of the package's users. */
export default defineConfig({
	root: fileURLToPath(new URL(".", import.meta.url)),
	base: "./",
	publicDir: false,
	logLevel: "warn",
	build: { target: "es2022", minify: false, outDir: fileURLToPath(new URL("../../build/forest", import.meta.url)) },
});
