import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";
import { inRun } from "../long_run.mjs";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("presets grow the same in Chromium as in Node, to the bit", async ({ page }) => {
	const path = fileURLToPath(new URL("./presets_in_node.ts", import.meta.url));
	const { module } = await runnerImport<typeof import("./presets_in_node")>(path, { configFile: false });
	const studio = await new StudioPage(page).open();
	for (const { name, fingerprint, berries } of module.grownInNode) {
		await studio.choosePreset("bunch", name);
		await expect(studio.fingerprint, name).toHaveText(fingerprint);
		await expect(studio.readout("Berries"), name).toHaveText(String(berries));
	}
	expect(module.grownInNode.length).toBeGreaterThanOrEqual(inRun(4, 15 + 12));
});

test("the strip lists shapes, varieties and other fruits apart, each with its picture in both themes", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open();
	await studio.presetsListed();
	const strip = page.getByRole("navigation", { name: "Presets" });
	const names = (section: string) => strip.getByRole("region", { name: section }).getByRole("button");
	await expect(names("Shapes")).toHaveCount(6);
	await expect(names("Other fruits")).toHaveText([/Redcurrant/, /Rubus/, /Lychee/, /Longan/, /Duku/]);
	expect(await names("Varieties").count()).toBeGreaterThanOrEqual(12);
	// Each with its picture.
	for (const theme of ["Dark theme", "Light theme"]) {
		const missing = await page.locator(".preset img").evaluateAll(async (pictures: HTMLImageElement[]) => {
			// Those far along the strip would not be fetched before they are scrolled to.
			for (const picture of pictures) picture.loading = "eager";
			const arrived = await Promise.allSettled(pictures.map((picture) => picture.decode()));
			return pictures.filter((_, i) => arrived[i].status === "rejected").map((picture) => picture.src);
		});
		expect(missing).toEqual([]);
		await page.getByRole("button", { name: theme }).click();
	}
});
