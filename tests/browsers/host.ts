/** The built app, and pages of another origin that have its element and its frame, as their users' hosts have them. */
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { serveUnder } from "../e2e/static_server";
import { withoutDrawing } from "../e2e/without_drawing.mjs";

const BASE = "/of/panicle/";

/**
 * The first script of a page: it records errors. A script before a page's policy is not subject to it. Firefox 153
 * warns that modules which already run could not be preloaded; a module's import reports real problems.
 */
const LISTENER = `<script>
	complaints = [];
	const { error } = console;
	console.error = (...words) => { complaints.push("console: " + words.join(" ")); error.apply(console, words); };
	addEventListener("error", ({ message, target }) => {
		if (target.rel !== "modulepreload") complaints.push("uncaught: " + (message ?? target.src ?? target.href));
	}, true);
	addEventListener("unhandledrejection", ({ reason }) => complaints.push("rejected: " + reason));
	addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) => complaints.push("policy: " + violatedDirective + " " + blockedURI));
</script>`;

const NO_DRAWING = `<script>(${withoutDrawing})()</script>`;

async function built(name: string, before: string) {
	const html = await readFile(fileURLToPath(new URL(`../../dist/${name}`, import.meta.url)), "utf8");
	return { html: html.replace("<head>", `<head>${before}`) };
}

/** Where the app lies, and where pages of somebody else do: addresses that end in a slash. */
export interface Host {
	/** All but the drawing, which by software costs more than all else. */
	readonly app: string;
	/** The page that draws as well. */
	readonly drawn: string;
	readonly others: string;
	close(): Promise<void>;
}

export async function startHost(): Promise<Host> {
	const [index, drawn, embed] = await Promise.all([
		built("index.html", LISTENER + NO_DRAWING),
		built("index.html", LISTENER),
		built("embed.html", LISTENER),
	]);
	const at = BASE.slice(1);
	const app = await serveUnder(BASE, "dist", { [at]: index, [`${at}drawn.html`]: drawn, [`${at}embed.html`]: embed });
	const page = (body: string) => ({
		html: `<!doctype html><html lang="en"><head>${LISTENER}<title>Plants</title><link rel="icon" href="data:,"></head><body>${body}</body></html>`,
	});
	const others = await serveUnder("/none/", "dist", {
		"element.html": page(
			`<script type="module" src="${app.address}panicle.js"></script><panicle-specimen preset="redcurrant" count="6" seed="7"></panicle-specimen>`,
		),
		"frame.html": page(""),
	});
	return {
		app: app.address,
		drawn: `${app.address}drawn.html`,
		others: new URL("/", others.address).href,
		close: async () => {
			await Promise.all([app.close(), others.close()]);
		},
	};
}
