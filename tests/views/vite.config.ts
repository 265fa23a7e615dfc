import { fileURLToPath } from "node:url";
import { mergeConfig } from "vite";
import application from "../../vite.config";

/** Builds a page with only views in build/views, for tests of the scene without the studio. */
const views = mergeConfig(application, {
	root: fileURLToPath(new URL(".", import.meta.url)),
	publicDir: false,
	logLevel: "warn",
	build: { outDir: fileURLToPath(new URL("../../build/views", import.meta.url)) },
});
// One page, and none of the application's.
export default { ...views, build: { ...views.build, rolldownOptions: {} } };
