import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

const caption = /([\d.]+ (?:cm|mm)) tall, (\d+) organs?, ([\d,]+) volumes/;

test("a flower's text is edited: it regrows, a mistake is told, undo and the link bring it back", async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=table-3");
	const words = page.getByText(caption).first();
	await expect(words).toContainText("4 organs");
	const grown = await studio.fingerprint.textContent();
	await studio.button("Grammar").click();
	const text = page.getByRole("region", { name: "Grammar" }).locator(".cm-content");
	await text.click();
	await page.keyboard.press("ControlOrMeta+Home");
	// The printed grammar with one more petal.
	await studio.regrown(() => page.keyboard.insertText("p0 RECEPTACLE -> RECEPTACLE[PETAL]_{C1}\n"));
	await expect(words).toContainText("5 organs");
	await expect(page).toHaveURL(/#g=/);
	const [more, link] = [await studio.fingerprint.textContent(), page.url()];
	await page.keyboard.insertText("p0 PETAL -> PETAL[SEPAL]_{E}\n");
	await expect(page.getByText(/“SEPAL” is not defined/).first()).toBeVisible();
	expect(await studio.fingerprint.textContent()).toBe(more);
	await page.goto("about:blank");
	await page.goto(link);
	await expect(studio.fingerprint).toHaveText(more ?? "");
	await page.goto("?v=2&model=flower&preset=table-3");
	await expect(studio.fingerprint).toHaveText(grown ?? "");
	// Another preset differs in nothing but its text.
	await studio.regrown(() => studio.choosePreset("flower", "figure-16"));
	await expect(words).not.toContainText("4 organs");
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(grown ?? "");
});

test("a click on a volume shows its numbers; a figure of the text is dragged, undone, and changes how many sides there are", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=petal");
	await studio.openGroup("Volume");
	const { x, y, width, height } = (await page.getByRole("application", { name: /^Flower/ }).boundingBox())!;
	await page.mouse.click(x + 0.5 * width, y + 0.45 * height);
	const name = page.locator(".volume-name");
	await expect(name).toHaveText(/^Petal/);
	await expect(page.locator(".volume-place")).toHaveText(
		/^(?:VEIN|[RL][UML]\d), volume \d+: segment \d+ of PETAL, which has \d+ volumes\.$/,
	);
	await expect(page.locator(".volume-values")).toContainText("atx");
	// The way without a pointer: the first volume is the stem.
	const number = page.getByLabel("Volume", { exact: true });
	await number.fill("1");
	await number.press("Enter");
	await expect(name).toHaveText("Stem");
	const before = await studio.fingerprint.textContent();
	const length = page.getByRole("slider", { name: "H, Every STEM", exact: true });
	await length.focus();
	await studio.regrown(() => length.press("ArrowRight"));
	await expect(page).toHaveURL(/#g=/);
	await expect(studio.fingerprint).not.toHaveText(before ?? "");
	await studio.regrown(() => page.keyboard.press("ControlOrMeta+z"));
	await expect(studio.fingerprint).toHaveText(before ?? "");
	await page.keyboard.press("Enter");
	await expect(page.getByRole("textbox", { name: "H, Every STEM, typed" })).toBeFocused();
	await page.keyboard.type("11");
	await studio.regrown(() => page.keyboard.press("Enter"));
	await expect(length).toHaveValue("11");
	await expect(length).toBeFocused();
	// Another order is another map.
	const darts = studio.readout("Darts");
	const few = await darts.textContent();
	const sides = page.getByRole("slider", { name: "N, Every STEM", exact: true });
	await sides.focus();
	await sides.press("ArrowRight");
	await expect(darts).not.toHaveText(few ?? "");
	// The same volume is chosen, and only its name is announced.
	await expect(page.locator("panicle-volume [aria-live]")).toHaveText("StemSTEM, volume 1.");
});

test("a chosen volume is let go with the flower that it was of; its sliders are explained", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=tulip&smooth=0");
	await studio.openGroup("Volume");
	const number = page.getByLabel("Volume", { exact: true });
	const name = page.locator(".volume-name");
	const choose = async (volume: string) => {
		await number.fill(volume);
		await number.press("Enter");
		await expect(name).toBeVisible();
	};
	await choose("1500");
	await page
		.getByRole("button", { name: /^About N, / })
		.first()
		.click();
	await expect(page.getByRole("note")).toHaveText(/^sides\. \d+ … \d+\./);
	await studio.regrown(() => page.locator("[data-preset=poppy]").click());
	await expect(page.getByText("Nothing selected")).toBeVisible();
	// A design has fewer volumes than that number.
	await choose("3000");
	await studio.regrown(() => studio.button("Design a new flower").click());
	await expect(page.getByText("Nothing selected")).toBeVisible();
});

test("a grammar as XML is dropped and grows; a mistake in one is reported with its place", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=figure-16");
	const volume = (category: string) => `<volume category="${category}"><name>STEM</name><degree>6</degree></volume>`;
	const xml = `${volume("#define")}<axiom>STEM</axiom><rule><predecessor>${volume("").replace("6", "")}</predecessor>
		<successor>${volume("root").replace("6", "")}<element>[</element>${volume("")}<element>]_</element><face>{E}</face></successor></rule>`;
	await studio.regrown(() => studio.drop("stem.xml", Buffer.from(xml)));
	await expect(studio.readout("Volumes")).toHaveText("11");
	const grown = await studio.fingerprint.textContent();
	await studio.drop("wrong.xml", Buffer.from(xml.replace("<axiom>", "<axiom>\n&")));
	await expect(page.getByText("wrong.xml: Line 2, column 1").first()).toBeVisible();
	await studio.drop("bare.gl3", Buffer.from("\n"));
	await expect(page.getByText("bare.gl3 is empty.").first()).toBeVisible();
	expect(await studio.fingerprint.textContent()).toBe(grown);
	const { name, bytes } = await studio.download("xml");
	expect(name).toMatch(/\.xml$/);
	expect(bytes.toString()).toContain("<axiom");
});

test("a flower's life is played from the bud, by stages and by numbers; undo and the link bring it back", {
	tag: "@long",
}, async ({ page }) => {
	const studio = await new StudioPage(page).open("?v=2&model=flower&preset=bluebell&smooth=0");
	const age = studio.slider("Age");
	const open = await studio.fingerprint.textContent();
	await expect(age).toHaveAttribute("aria-valuetext", "Open, 1");
	// It stands open, so all of its life is shown.
	await studio.regrown(() => studio.button("Play").click());
	await expect.poll(async () => Number(await age.inputValue())).toBeLessThan(0.9);
	await studio.button("Pause").click();
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(open ?? "");
	await age.focus();
	const shut = await studio.regrown(() => page.keyboard.press("PageDown"));
	await expect(age).toHaveAttribute("aria-valuetext", "Opening, 0.5");
	await expect(page).toHaveURL(/[?&]age=0\.5\b/);
	const field = page.getByRole("textbox", { name: "Age, typed" });
	await field.fill("3");
	await studio.regrown(() => field.press("Enter"));
	await expect(age).toHaveAttribute("aria-valuetext", "Wilted, 2");
	await expect(studio.notices).toContainText("Age must be from 0 to 2");
	await studio.regrown(() => studio.button("Undo").click());
	await expect(studio.fingerprint).toHaveText(shut);
	// A text without age has no animation.
	await studio.open("?v=2&model=flower&preset=figure-16");
	await expect(studio.button("Play")).toHaveCount(0);
});
