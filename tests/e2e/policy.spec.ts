import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("the page may do what it does and nothing else", async ({ page, complaints }) => {
	complaints.expect(/Content Security Policy|violates|blob:.* csp/i);
	const studio = await new StudioPage(page).open();
	await expect(studio.canvas).toHaveAccessibleName(/berries/);
	expect(complaints.unexpected()).toEqual([]);
	const refused = await page.evaluate(async () => {
		const found: string[] = [];
		document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => found.push(effectiveDirective));
		const picture = (src: string) => {
			document.body.append(Object.assign(new Image(), { src }));
		};
		const script = document.createElement("script");
		script.textContent = "globalThis.ran = true";
		document.body.append(script);
		const style = document.createElement("style");
		style.textContent = "body { color: red }";
		document.body.append(style);
		picture("data:image/gif;base64,R0lGODlhAQABAAAAACw=");
		picture(URL.createObjectURL(new Blob(["x"], { type: "image/png" })));
		await fetch(URL.createObjectURL(new Blob(["x"]))).catch(() => {});
		await fetch("https://example.org/").catch(() => {});
		document.body.insertAdjacentHTML(
			"beforeend",
			"<iframe src='about:blank#x'></iframe><object data='x.swf'></object>",
		);
		await new Promise((resolve) => setTimeout(resolve, 300));
		return { found: [...new Set(found)].sort(), ran: "ran" in globalThis };
	});
	expect(refused).toEqual({
		found: expect.arrayContaining(["connect-src", "img-src", "script-src-elem", "style-src-elem"]),
		ran: false,
	});
	const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
	expect(policy?.split("; ").sort()).toEqual([
		"base-uri 'none'",
		"connect-src 'self'",
		"default-src 'none'",
		"font-src 'self'",
		"form-action 'none'",
		"img-src 'self'",
		"manifest-src 'self'",
		"script-src 'self' 'wasm-unsafe-eval'",
		"style-src 'self'",
		"worker-src 'self' blob:",
	]);
});
