import { fileURLToPath } from "node:url";
import { mergeConfig } from "vite";
import application from "../../vite.config";

/** Builds the application with the toy in build/toy: the same page, another script. */
export default mergeConfig(application, {
	root: fileURLToPath(new URL("../../web", import.meta.url)),
	logLevel: "warn",
	build: { outDir: fileURLToPath(new URL("../../build/toy", import.meta.url)) },
	plugins: [
		{
			name: "toy",
			transformIndexHtml: {
				order: "pre",
				handler: (html: string) => html.replace("./src/app/main.ts", "../tests/toy/page.ts"),
			},
		},
	],
});
