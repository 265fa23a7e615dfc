import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("the page's own policy lets no foreign code, style, frame or address in", async ({ page, complaints }) => {
	await new StudioPage(page).open();
	complaints.expect(/Content Security Policy|violates the following|elsewhere\.example\S* csp/);
	// Attacks that a text injected into the page could try.
	const refused = await page.evaluate(async () => {
		const blocked: string[] = [];
		document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => blocked.push(effectiveDirective));
		const element = (tag: string, attributes: Record<string, string>, text = "") => {
			const made = Object.assign(document.createElement(tag), attributes);
			made.textContent = text;
			document.body.append(made);
		};
		element("script", {}, "window.broughtIn = true");
		element("style", {}, "body { outline: 1px solid red }");
		element("img", { src: "https://elsewhere.example/picture.png" });
		element("iframe", { src: "https://elsewhere.example/" });
		await fetch("https://elsewhere.example/").catch(() => {});
		// The browser reports violations of the policy later.
		for (let waits = 0; waits < 100 && new Set(blocked).size < 5; waits++)
			await new Promise((resolve) => setTimeout(resolve, 100));
		return { blocked: [...new Set(blocked)].sort(), ran: "broughtIn" in window };
	});
	expect(refused.ran).toBe(false);
	expect(refused.blocked).toEqual(
		expect.arrayContaining(["connect-src", "frame-src", "img-src", "script-src-elem", "style-src-elem"]),
	);
});
