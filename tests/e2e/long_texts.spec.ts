/** Long texts: the number of elements that they add to the page is limited. */
import { EditorPage } from "./editor_page";
import { expect, test } from "./fixtures";

test("of 15,000 constants only the rows in sight are in the page, and search and the Tab key reach all of them", async ({
	page,
}) => {
	const studio = await new EditorPage(page).open("?v=2&model=grammar");
	const defines = Array.from({ length: 15_000 }, (_, index) => `#define c${index} 5`).join("\n");
	await studio.drop("many.lsys", Buffer.from(`axiom: F(c0)\n${defines}\n`));
	await studio.openAdvanced();
	const list = page.getByRole("list", { name: "Constants" });
	const rows = list.getByRole("listitem");
	await expect(rows.first()).toHaveAttribute("aria-setsize", "15000");
	const size = () =>
		page
			.locator("panicle-constants")
			.last()
			.evaluate((element) => element.querySelectorAll("*").length);
	expect(await size()).toBeLessThan(400);

	// The focus stays where the list is scrolled away from it, and goes on from there.
	await studio.slider("c1").focus();
	const scroller = page.locator(".long-list");
	await scroller.scrollIntoViewIfNeeded();
	await scroller.evaluate((element) => element.scrollTo(0, element.scrollHeight));
	await expect(studio.slider("c14999")).toBeInViewport();
	await expect(studio.slider("c1")).toBeFocused();
	expect(await size()).toBeLessThan(400);
	/** Goes to the next slider: the explanation of a constant is a stop, too. */
	const next = async () => {
		for (const _ of ["explanation", "slider"]) await page.keyboard.press("Tab");
	};
	await next();
	await expect(studio.slider("c2")).toBeFocused();
	await expect(studio.slider("c2")).toBeInViewport();
	for (let count = 3; count < 20; count++) await next();
	await expect(studio.slider("c19")).toBeFocused();

	await page.getByRole("searchbox", { name: "Search constants" }).fill("c77");
	await expect(rows.first()).toHaveAttribute("aria-setsize", "111");
	await expect(page.getByRole("search", { name: "Constants" })).toContainText("111 of 15,000 constants");
	await page.getByRole("searchbox", { name: "Search constants" }).fill("c0");
	await studio.regrown(() => studio.slider("c0").press("ArrowRight"));
	await studio.button("Grammar").click();
	await expect(studio.text).toContainText("#define c0 6");
});

test("a curve of thousands of points is drawn without a handle for each", async ({ page }) => {
	const studio = await new EditorPage(page).open("?v=2&model=grammar");
	const points = Array.from({ length: 5000 }, (_, index) => `(${index}, ${index % 2})`).join(" ");
	await studio.drop("curve.lsys", Buffer.from(`#curve wave ${points}\naxiom: F(wave(2))\n`));
	await studio.openAdvanced();
	const curve = page.getByRole("group", { name: "Curve wave" });
	await expect(curve).toContainText("5,000 points. Edit them in the grammar.");
	expect(await curve.evaluate((element) => element.querySelectorAll("*").length)).toBeLessThan(20);
});

test("a line of 248 KB puts no more into the page than what is seen of it", async ({ page }) => {
	const studio = await new EditorPage(page).open("?v=2&model=grammar");
	await studio.drop("line.lsys", Buffer.from(`axiom: ${"F(1)[+(25)F(3)]".repeat(16_900)}\n`));
	await studio.button("Grammar").click();
	await expect(studio.text).toContainText("F(1)[+(25)F(3)]");
	const size = () => studio.text.evaluate((element) => element.querySelectorAll("*").length);
	expect(await size()).toBeLessThan(100);
	await studio.text.press("Control+Home");
	await page.keyboard.type("/**/");
	await expect(studio.text).toContainText("/**/axiom");
	expect(await size()).toBeLessThan(100);
});
