import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

it("the content security policy allows exactly what the page needs", () => {
	const page = readFileSync(new URL("../../../web/index.html", import.meta.url), "utf8");
	const policy = /<meta http-equiv="Content-Security-Policy" content="([^"]+)">/.exec(page)?.[1];
	expect(policy?.split("; ").sort()).toEqual([
		"base-uri 'none'",
		"connect-src 'self'",
		"default-src 'none'",
		"font-src 'self'",
		"form-action 'none'",
		"frame-src 'self'",
		"img-src 'self'",
		"manifest-src 'self'",
		"script-src 'self' 'wasm-unsafe-eval'",
		"style-src 'self'",
		"worker-src 'self' blob:",
	]);
	// The policy applies only to elements after it.
	expect(page.indexOf("Content-Security-Policy")).toBeLessThan(page.indexOf("<script"));
	expect(page.indexOf("Content-Security-Policy")).toBeLessThan(page.indexOf("<link"));
});
