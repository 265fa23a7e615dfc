import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";

const repository = new URL("../../", import.meta.url);

const TYPES: Readonly<Record<string, string>> = {
	".html": "text/html",
	".js": "text/javascript",
	".css": "text/css",
	".svg": "image/svg+xml",
	".wasm": "application/wasm",
	".woff2": "font/woff2",
	".webp": "image/webp",
	".webmanifest": "application/manifest+json",
};

/** A page of a host's own: its HTML, and the policy it is sent with. */
export interface HostPage {
	readonly html: string;
	readonly policy?: string;
}

/**
 * A static host with a built app below `base`, for pages of any origin, and with the given pages.
 *
 * @param pages by their names at the root: `plant.html`
 * @param policy sent with every file of the app, workers' scripts included
 */
export async function serveUnder(
	base: string,
	app = "dist",
	pages: Readonly<Record<string, HostPage>> = {},
	policy?: string,
): Promise<{ address: string; close(): Promise<void> }> {
	const folder = fileURLToPath(new URL(`${app}/`, repository));
	const server = createServer(async (request, response) => {
		const { pathname } = new URL(request.url ?? "/", "http://host");
		const page = pages[pathname.slice(1)];
		if (page) {
			const policy = page.policy ? { "content-security-policy": page.policy } : {};
			response.writeHead(200, { "content-type": "text/html", ...policy }).end(page.html);
			return;
		}
		try {
			if (!pathname.startsWith(base)) throw new Error("outside");
			const file = join(folder, pathname.slice(base.length) || "index.html");
			const bytes = await readFile(file);
			const type = TYPES[extname(file)] ?? "application/octet-stream";
			const headers = policy ? { "content-security-policy": policy } : {};
			response.writeHead(200, { "content-type": type, "access-control-allow-origin": "*", ...headers }).end(bytes);
		} catch {
			response.writeHead(404).end();
		}
	});
	await new Promise<void>((resolve) => server.listen(0, "localhost", resolve));
	return {
		address: `http://localhost:${(server.address() as AddressInfo).port}${base}`,
		close: () => {
			server.closeAllConnections();
			return new Promise((resolve) => server.close(() => resolve()));
		},
	};
}
