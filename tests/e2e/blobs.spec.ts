import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("no picture and no request comes from a data: or blob: address; the page needs none", async ({
	page,
	complaints,
}) => {
	const studio = await new StudioPage(page).open();
	await expect(studio.canvas).toHaveAccessibleName(/berries/);
	expect(complaints.unexpected()).toEqual([]);
	complaints.expect(/Content Security Policy|violates|blob:.* csp/i);
	const refused = await page.evaluate(async () => {
		const found: string[] = [];
		document.addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) =>
			found.push(`${effectiveDirective} ${blockedURI.split(":")[0]}`),
		);
		const blob = () => URL.createObjectURL(new Blob(["x"], { type: "image/png" }));
		for (const src of ["data:image/gif;base64,R0lGODlhAQABAAAAACw=", blob()])
			document.body.append(Object.assign(new Image(), { src }));
		for (const address of ["data:,x", blob()]) await fetch(address).catch(() => {});
		// The events come after the requests.
		for (let waits = 0; waits < 100 && found.length < 4; waits++)
			await new Promise((resolve) => setTimeout(resolve, 100));
		return found.sort();
	});
	expect(refused).toEqual(["connect-src blob", "connect-src data", "img-src blob", "img-src data"]);
});
