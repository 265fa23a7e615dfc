/** Texts of trees and stands as files: downloaded, opened again, dropped under another name. */
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const PLANTS = [
	{ of: "a tree of growth", link: "?v=2&model=growth&preset=table-1-sigma1&seed=4&steps=5", format: "growth" },
	{ of: "a stand", link: "?v=2&model=stand&preset=flowerbed&seed=2", format: "stand" },
];

for (const { of, link, format } of PLANTS) {
	test(`the grammar of ${of} is downloaded, and opened it brings the plant back`, async ({ page }) => {
		const studio = await new StudioPage(page).open(link);
		const grown = await studio.fingerprint.innerText();
		const { name, bytes } = await studio.download(format);
		expect(name).toMatch(new RegExp(`\\.${format}$`));
		expect(bytes.toString().split("\n")[0]).toBe(`/* Panicle ${link} */`);
		await new StudioPage(page).open("?v=2&model=leaf");
		const choosing = page.waitForEvent("filechooser");
		await studio.button("Open…").click();
		await (await choosing).setFiles({ name, mimeType: "text/plain", buffer: bytes });
		await expect(studio.fingerprint).toHaveText(grown);
		await expect(page).toHaveURL(new RegExp(`model=${format}`));
	});
}

test("a text decides its model, whatever its file is called and whatever is shown", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=grammar");
	const tree = 'gs = 4\nfootprint -> GrowVol(1, 1, 3, 6, 2, 0)\ntree -> DivFunc("sigma1"){branches}\n';
	await studio.regrown(() => studio.drop("oak.lsys", Buffer.from(tree)));
	await expect(page).toHaveURL(/model=growth/);
	const roles = "#role pedicel Ap\naxiom: Ap\nAp --> F(30) S(12)\n";
	await studio.regrown(() => studio.drop("bunch.growth", Buffer.from(roles)));
	await expect(page).toHaveURL(/\?v=2#g=/);
});
