/** docs/hosting.md lists the headers that the pages need. */
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const docs = read("docs/hosting.md");

/** The policy in the `<meta>` of a page, by directive. */
function policyOf(page: string): Map<string, readonly string[]> {
	const [, policy = ""] = /<meta http-equiv="Content-Security-Policy" content="([^"]+)">/.exec(read(page)) ?? [];
	return directivesOf(policy);
}

function directivesOf(policy: string): Map<string, readonly string[]> {
	const directives = policy.split("; ").map((directive) => directive.split(" "));
	return new Map(directives.map(([name, ...sources]) => [name, sources]));
}

/** An example of the page by the name of its file. */
function example(title: string): string {
	const [, body = ""] =
		new RegExp(`\`\`\`\\w+ title="${title.replaceAll(".", "\\.")}"\\n([^\`]*)\`\`\``).exec(docs) ?? [];
	return body;
}

/** The headers of a `_headers` file: values by rule and name. */
function rulesOf(text: string): Map<string, Map<string, string>> {
	const rules = new Map<string, Map<string, string>>();
	let rule = new Map<string, string>();
	for (const line of text.trimEnd().split("\n")) {
		const [, name, value] = /^ {2}([\w-]+): (.+)$/.exec(line) ?? [];
		if (name) {
			rule.set(name, value);
			continue;
		}
		rule = new Map();
		rules.set(line, rule);
	}
	return rules;
}

const FRAMED_BY_ITSELF = ["frame-ancestors", ["'self'"]] as const;

describe("the policy that the docs tell hosts to send", () => {
	const pages = policyOf("web/index.html");

	it("is the policy of the built page, and in `_headers` only the app's page may not be framed by others", () => {
		const rules = rulesOf(example("_headers"));
		const policies = [...rules].flatMap(([rule, headers]) => {
			const policy = headers.get("Content-Security-Policy");
			return policy ? [[rule, directivesOf(policy)] as const] : [];
		});
		expect(policies).toEqual([
			["/*", pages],
			["/", new Map([FRAMED_BY_ITSELF])],
			["/index.html", new Map([FRAMED_BY_ITSELF])],
		]);
	});

	it("is the policy of the built page for nginx, with `frame-ancestors` for all but `embed.html`", () => {
		const text = example("panicle.conf");
		const [, policy = ""] = /add_header Content-Security-Policy "([^"]+)\$panicle_framing" always;/.exec(text) ?? [];
		expect(directivesOf(policy)).toEqual(pages);
		expect(text).toContain("default \"; frame-ancestors 'self'\";");
		expect(text).toContain('~/embed\\.html$ "";');
	});

	it("is the policy of the built page for Apache, with `frame-ancestors` for all but `embed.html`", () => {
		const policies = [...example(".htaccess").matchAll(/Content-Security-Policy "([^"]+)"/g)];
		expect(policies.map(([, policy]) => directivesOf(policy))).toEqual([new Map([...pages, FRAMED_BY_ITSELF]), pages]);
	});

	it("allows `embed.html` all that its own policy allows", () => {
		for (const [directive, sources] of policyOf("web/embed.html")) {
			expect([directive, pages.get(directive)]).toEqual([directive, sources]);
		}
	});

	it("is in no page with a directive that browsers ignore in a `<meta>`", () => {
		for (const page of ["web/index.html", "web/embed.html"]) {
			for (const ignored of ["frame-ancestors", "report-uri", "sandbox"])
				expect(policyOf(page).has(ignored)).toBe(false);
		}
	});
});

it("sends each file of all three hosts with the same headers", () => {
	const names = [...docs.matchAll(/^\| `([\w-]+)` \|/gm)].map(([, name]) => name);
	const sent = ["Content-Security-Policy", "X-Content-Type-Options", "Access-Control-Allow-Origin", "Cache-Control"];
	expect(names).toEqual(expect.arrayContaining(sent));
	for (const title of ["_headers", "panicle.conf", ".htaccess"]) {
		const crossOrigin = ["Cross-Origin-Resource-Policy", "Cross-Origin-Embedder-Policy"];
		for (const name of [...sent, ...crossOrigin])
			expect([title, name, example(title).includes(name)]).toEqual([title, name, true]);
		expect(example(title)).toContain("max-age=31536000, immutable");
	}
});
