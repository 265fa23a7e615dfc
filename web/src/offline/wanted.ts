/** What a request is for: a file of the app, by its path in the app's folder (the page itself is ""), or a specimen's. */
export type Wanted = { readonly file: string } | "specimen" | undefined;

/** @param scope the app's folder, as a whole address that ends in a slash; undefined is what is left to the network */
export function wantedBy({ url, method, cache }: Pick<Request, "url" | "method" | "cache">, scope: string): Wanted {
	const [address] = url.split(/[?#]/, 1);
	if (!address.startsWith(scope)) return undefined;
	const path = address.slice(scope.length);
	if (path.startsWith("specimens/")) return "specimen";
	// Who asks past everything that is kept, as the page does that looks for a newer version, means the network.
	if (method !== "GET" || cache === "no-store") return undefined;
	return { file: path === "index.html" ? "" : path };
}
