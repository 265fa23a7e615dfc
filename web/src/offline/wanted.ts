/**
 * The target of a request: a file of the app, by its path in the app's folder (the page itself is ""), or a specimen's
 * file.
 */
export type WantedFile = { readonly file: string } | "specimen" | undefined;

/**
 * Returns the file of the app, or "specimen", that a request is for.
 * @param scope the app's folder, as a whole address that ends in a slash
 * @returns undefined where the request is left to the network
 */
export function wantedBy({ url, method, cache }: Pick<Request, "url" | "method" | "cache">, scope: string): WantedFile {
	const [address] = url.split(/[?#]/, 1);
	if (!address.startsWith(scope)) return undefined;
	const path = address.slice(scope.length);
	if (path.startsWith("specimens/")) return "specimen";
	// Requests that bypass caches, such as the page's check for a newer version, go to the network.
	if (method !== "GET" || cache === "no-store") return undefined;
	return { file: path === "index.html" ? "" : path };
}
