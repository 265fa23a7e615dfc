import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

test("a flowerbed is shown as it comes and counted; a click on a plant opens it, the same flower", {
	tag: "@long",
}, async ({ page }) => {
	const caption = page.getByText(/^240 plants of 9 kinds on 2\.2 × 1\.3 m$/).first();
	const partly = page.getByText(/; \d+ grown so far/).first();
	const opening = new StudioPage(page).open("?v=2&model=stand&preset=flowerbed&many=240");
	await expect(partly).toBeVisible();
	const studio = await opening;
	await expect(partly).toHaveCount(0);
	await expect(caption).toBeVisible();

	// The map and the picture show the same plant; the number beside it identifies it.
	const plan = page.getByRole("region", { name: "Map view" });
	const { x, y, width, height } = (await plan.locator("svg").first().boundingBox())!;
	await page.mouse.click(x + 0.4 * width, y + 0.2 * height);
	const description = await plan.getByText(/^Plant \d+: /).textContent();
	const [, title] = /: (.+)$/.exec(description ?? "") ?? [];
	// Each sort has one name in the list, however many lines of the plan it has.
	expect(await plan.getByRole("listitem").filter({ hasText: title }).count()).toBe(1);
	const downloaded = (await studio.download("json")).bytes.toString();
	const { plants } = JSON.parse(downloaded) as { plants: { fingerprint: string }[] };
	const number = Number(/Plant (\d+)/.exec(description ?? "")?.[1]);
	await plan.getByRole("link", { name: "Open this plant" }).click();
	await expect(page).toHaveURL(/model=flower/);
	await expect(studio.fingerprint).toHaveText(plants[number - 1].fingerprint);
	await expect(page.getByText(/ tall, \d+ organs?, /).first()).toBeVisible();
});
