/** Puts the documentation site beside the app, as its folder `docs`. It is not part of the offline app. */
import { cpSync, createReadStream, existsSync, statSync } from "node:fs";
import { extname, join } from "node:path";
import { buildSite } from "../wasm-core/tools/site/build.mjs";

/** The folder in the built app. */
export const DOCS = "docs";

const TYPES = {
	".css": "text/css",
	".html": "text/html",
	".jpg": "image/jpeg",
	".js": "text/javascript",
	".json": "application/json",
	".svg": "image/svg+xml",
	".txt": "text/plain; charset=utf-8",
	".webp": "image/webp",
};

/** The file of the site that an address names; undefined where there is none. */
function fileAt(folder, url) {
	const path = decodeURIComponent(new URL(url, "http://page").pathname);
	const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
	return file.startsWith(folder) && existsSync(file) && statSync(file).isFile() ? file : undefined;
}

/** @returns {import("vite").Plugin} */
export function docsSite() {
	/** @type {ReturnType<typeof buildSite> | undefined} */
	let building;
	return {
		name: "docs-site",
		configureServer({ middlewares }) {
			middlewares.use(`/${DOCS}`, (request, response, next) => {
				const serve = async () => {
					const file = fileAt(await buildSite(), request.url ?? "/");
					if (!file) return next();
					response.setHeader("content-type", TYPES[extname(file)] ?? "application/octet-stream");
					createReadStream(file).pipe(response);
				};
				// Vite shows what is wrong, such as a broken link.
				serve().catch(next);
			});
		},
		buildStart() {
			if (this.meta.watchMode) return;
			building ??= buildSite();
			// The error is reported where the site is awaited.
			building.catch(() => {});
		},
		async writeBundle({ dir }) {
			if (building) cpSync(await building, join(dir, DOCS), { recursive: true });
		},
	};
}
