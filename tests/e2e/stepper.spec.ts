import type { Locator } from "@playwright/test";
import { expect, test } from "./fixtures";
import { StudioPage } from "./studio_page";

/** The page with the derivation open below its grammar. */
class StepperPage extends StudioPage {
	get text(): Locator {
		return this.page.getByRole("textbox", { name: "Grammar", exact: true });
	}

	get string(): Locator {
		return this.page.getByRole("listbox", { name: /^String: / });
	}

	get modules(): Locator {
		return this.string.getByRole("option");
	}

	get chosen(): Locator {
		return this.string.getByRole("option", { selected: true });
	}

	get details(): Locator {
		return this.page.locator(".trace-card");
	}

	get step(): Locator {
		return this.slider("Step");
	}

	/** @param text of a plant in place of the link's */
	async steps(search: string, text?: string): Promise<this> {
		await this.open(search);
		if (text !== undefined) await this.regrown(() => this.drop("own.lsys", Buffer.from(text)));
		await this.button("Grammar").click();
		await this.button("Steps").click();
		await expect(this.modules.first()).toBeVisible();
		return this;
	}

	/** Waits for the string of a step, its modules joined. */
	async reads(string: string): Promise<void> {
		await expect.poll(async () => (await this.modules.allInnerTexts()).join("")).toBe(string);
	}

	/** How much of a picture of the view shines. */
	async shining(): Promise<{ count: number; x: number; y: number }> {
		const view = this.page.locator("canvas.stage-surface");
		const { data, width } = await this.pixels(view);
		const box = await view.boundingBox();
		let [count, x, y] = [0, 0, 0];
		for (let at = 0; at < data.length; at += 4) {
			// Orange, on paper, wood and leaves.
			if (data[at] < 150 || data[at] - data[at + 1] < 60 || data[at + 1] - data[at + 2] < 30) continue;
			count++;
			x += (at / 4) % width;
			y += Math.floor(at / 4 / width);
		}
		return { count, x: (box?.x ?? 0) + x / count, y: (box?.y ?? 0) + y / count };
	}
}

test.use({ viewport: { width: 1280, height: 900 } });

/** Fibonacci's filament, b: a → a b, b → a. */
const ALGAE = "?v=2&model=grammar&preset=algae";
/** Its strings by hand. */
const FIBONACCI = ["b", "a", "ab", "aba", "abaab", "abaababa"];

test("strings, parents and children of the algae are those worked out by hand, and the link knows nothing of it", async ({
	page,
}) => {
	const studio = await new StepperPage(page).steps(ALGAE);
	const link = page.url();
	await expect(studio.step).toHaveAttribute("max", "9");
	await expect(studio.step).toHaveValue("9");
	await expect(studio.modules).toHaveCount(55);
	await studio.step.fill("4");
	await studio.reads(FIBONACCI[4]);
	await expect(studio.string).toHaveAccessibleName("String: Step 4 of 9, 5 modules");
	await studio.modules.nth(3).click();
	await expect(studio.details).toContainText("4 of 5");
	await expect(studio.details).toContainText("Produced by line 10.");
	await expect(studio.details).toContainText("Rewritten in the next step by line 10");
	await expect(studio.details).toContainText("The module is replaced by 2 modules.");
	await expect(studio.text.locator(".cm-fires")).toHaveText("a --> a b");
	await studio.string.focus();
	await page.keyboard.press("ArrowUp");
	await studio.reads(FIBONACCI[3]);
	await expect(studio.chosen).toHaveAttribute("aria-posinset", "3");
	await page.keyboard.press("ArrowDown");
	await studio.reads(FIBONACCI[4]);
	await expect(studio.chosen).toHaveAttribute("aria-posinset", "4");
	await page.keyboard.press("ArrowDown");
	await studio.reads(FIBONACCI[5]);
	await expect(studio.chosen).toHaveAttribute("aria-posinset", "6");
	await expect(studio.string).toBeFocused();
	await page.keyboard.press("Home");
	await expect(studio.chosen).toHaveAttribute("aria-posinset", "1");
	await expect(studio.string).toHaveAttribute("aria-activedescendant", "module-0");
	await page.keyboard.press("Enter");
	await expect(studio.text).toBeFocused();
	expect(page.url()).toBe(link);
	await studio.button("Steps").click();
	await expect(studio.string).toHaveCount(0);
	await expect(studio.text.locator(".cm-fires")).toHaveCount(0);
});

test("a module lists the productions that do not rewrite it, and why; each leads to its line", async ({ page }) => {
	const text = "axiom: A(3) [ B ]\nA(x) : x>4 --> F\nA(x) > B --> F\nA(x) --> F(x) A(x+1)\n";
	const studio = await new StepperPage(page).steps("?v=2&model=grammar", text);
	await studio.step.fill("0");
	await studio.modules.first().click();
	const others = studio.details.getByRole("list", { name: "Productions that were not used, and why" });
	await expect(others.getByRole("listitem")).toHaveText([
		"Not rewritten by line 2: the condition is false with x = 3.",
		"Not rewritten by line 3: the “B” after the module is in a branch; to match it there, write “> [ B ]”.",
	]);
	await expect(studio.details).toContainText("Rewritten in the next step by line 4 with x = 3");
	await others.getByRole("button", { name: "line 3" }).click();
	await expect(studio.text).toBeFocused();
});

test("the modules of the production at the cursor are marked", { tag: "@long" }, async ({ page }) => {
	const studio = await new StepperPage(page).steps(ALGAE);
	await studio.step.fill("4");
	await studio.reads(FIBONACCI[4]);
	await studio.text.locator(".cm-line", { hasText: "a --> a b" }).click();
	await expect(studio.modules.and(page.locator(".rewritten"))).toHaveCount(3);
	await expect(studio.modules.and(page.locator(".written"))).toHaveCount(4);
	// The marks are lines, not only colours.
	await expect(page.locator(".module.rewritten").first()).toHaveCSS("border-bottom-style", "solid");
	await expect(page.locator(".module.written").first()).toHaveCSS("text-decoration-line", "overline");
	await expect(studio.details).toContainText(
		"The production on line 10 produced 4 of the modules and rewrites 3 in the next step.",
	);
});

test("a slider dragged fast shows no string but of the step where it stands", { tag: "@long" }, async ({ page }) => {
	const studio = await new StepperPage(page).steps(ALGAE);
	const wrong = await page.evaluate(async (strings) => {
		const slider = document.querySelector<HTMLInputElement>(".step-slide input");
		const found: string[] = [];
		for (let turn = 0; turn < 60 && slider; turn++) {
			const step = (turn * 7) % strings.length;
			slider.value = String(step);
			slider.dispatchEvent(new Event("input", { bubbles: true }));
			await new Promise((resolve) => setTimeout(resolve, (turn % 5) * 4));
			const shown = [...document.querySelectorAll(".derived .module")].map((each) => each.textContent).join("");
			if (shown !== "" && shown !== strings[step]) found.push(`${step}: ${shown}`);
		}
		return found;
	}, FIBONACCI);
	expect(wrong).toEqual([]);
	await studio.reads(FIBONACCI[(59 * 7) % FIBONACCI.length]);
});

test("in context, only what has its neighbour is rewritten; by chance, the lot is told", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StepperPage(page).steps("?v=2&model=grammar&preset=signal");
	await studio.button("First step").click();
	await studio.reads("baaaaaaaa");
	await expect(studio.string.locator(".fires")).toHaveCount(2);
	await studio.modules.nth(1).click();
	await expect(studio.details).toContainText("Rewritten in the next step by line 10");
	await studio.button("Step forward").click();
	await studio.reads("abaaaaaaa");
	await expect(studio.chosen).toHaveText("b");
	await page.goto("about:blank");
	await studio.steps("?v=2&model=grammar&preset=stochastic-plant");
	await studio.button("First step").click();
	await studio.reads("F");
	await studio.modules.first().click();
	await expect(studio.details).toContainText(/line 1\d\. +Random choice: probability 0\.3[34] of 1 \(drew 0\.\d+\)/);
});

test("a mistake in the text leaves the string; a change derives anew", { tag: "@long" }, async ({ page }) => {
	const studio = await new StepperPage(page).steps(ALGAE);
	await studio.step.fill("3");
	await studio.reads("aba");
	await studio.text.locator(".cm-line", { hasText: /^axiom/ }).click();
	await page.keyboard.press("End");
	await page.keyboard.type(" )");
	await expect(page.locator(".pane-messages").getByRole("button", { name: /^Line 8/ })).toBeVisible();
	await studio.reads("aba");
	await page.keyboard.press("Backspace");
	await page.keyboard.type("b");
	await studio.reads("abaaba");
});

test("a step that cannot be traced leaves the others in reach", { tag: "@long" }, async ({ page }) => {
	await page.addInitScript(() => {
		// The core refuses a step that is no whole number.
		const post = Worker.prototype.postMessage;
		Worker.prototype.postMessage = function (message, ...more: unknown[]) {
			for (const block of message.blocks ?? [])
				if (block.name === "chronicle_step" && block.data[0] === 4) block.data = Float32Array.of(4);
			Reflect.apply(post, this, [message, ...more]);
		};
	});
	const studio = await new StepperPage(page).steps(ALGAE);
	await studio.step.fill("4");
	await expect(page.getByRole("status").filter({ hasText: "The steps cannot be told: " })).toBeVisible();
	await expect(studio.modules).toHaveCount(0);
	await studio.button("Step forward").click();
	await studio.reads(FIBONACCI[5]);
});

test("steps are played until the last, and stop at a hand on the slider", { tag: "@long" }, async ({ page }) => {
	const studio = await new StepperPage(page).steps(ALGAE);
	await studio.step.fill("7");
	await studio.button("Play the steps").click();
	await expect(studio.step).toHaveValue("9");
	await expect(studio.button("Play the steps")).toBeVisible();
	await studio.button("Play the steps").click();
	await expect(studio.step).toHaveValue("1");
	await studio.step.fill("5");
	await expect(studio.button("Play the steps")).toBeVisible();
});

test("a long string is there a window at a time, and is walked through to its ends", { tag: "@long" }, async ({
	page,
}) => {
	const studio = await new StepperPage(page).steps("?v=2&model=grammar&preset=stochastic-plant");
	const place = studio.slider("Position in the string");
	const length = Number(await studio.modules.first().getAttribute("aria-setsize"));
	expect(length).toBeGreaterThan(1500);
	await expect(studio.modules).toHaveCount(600);
	await studio.string.focus();
	await page.keyboard.press("End");
	await expect(studio.chosen).toHaveAttribute("aria-posinset", String(length));
	await expect(studio.chosen).toBeInViewport();
	await expect(place).toHaveValue(String(length - 1));
	await place.fill("900");
	await expect(studio.chosen).toHaveAttribute("aria-posinset", "901");
	await studio.string.evaluate((list) => list.scrollTo(0, list.scrollHeight));
	await expect(studio.modules.first()).not.toHaveAttribute("aria-posinset", "601");
});

test.describe("in the view", () => {
	test.use({ drawn: true, viewport: { width: 1000, height: 700 } });

	test("the chosen module shines, and what is clicked there is chosen in the string", { tag: "@long" }, async ({
		page,
	}) => {
		const text = "derivation length: 2\naxiom: A\nA --> B C\nB --> F\nC --> F [ +(60) F ] F\n";
		const studio = await new StepperPage(page).steps("?v=2&model=grammar", text);
		await studio.stands();
		await studio.reads("FF[+(60)F]F");
		const plain = await studio.shining();
		await studio.modules.nth(4).click();
		await page.mouse.move(5, 5);
		await expect.poll(async () => (await studio.shining()).count).toBeGreaterThan(plain.count + 60);
		const { x, y } = await studio.shining();
		await studio.modules.first().click();
		await expect(studio.chosen).toHaveAttribute("aria-posinset", "1");
		await page.mouse.click(x, y);
		await expect(studio.chosen).toHaveAttribute("aria-posinset", "5");
		await page.mouse.move(x + 1, y);
		await expect(studio.string.locator(".pointed")).toHaveText("F");
		// The module does not exist in the step before: its ancestor is chosen, and all descendants of that are
		// highlighted.
		await studio.button("Show the plant as it was after this step").click();
		await studio.step.fill("1");
		await studio.reads("BC");
		await page.mouse.click(x, y);
		await expect(studio.chosen).toHaveText("C");
	});

	test("the plant is shown as it was after this step, and the whole again where that is not wanted", {
		tag: "@long",
	}, async ({ page }) => {
		const studio = await new StepperPage(page).steps(ALGAE);
		await studio.stands();
		await studio.step.fill("6");
		const caption = page.locator("panicle-stage .caption p");
		await expect(caption).toHaveText("After step 6: 13 modules, 13 segments");
		await studio.button("Show the plant as it was after this step").click();
		await expect(caption).toHaveText("55 modules, 55 segments");
		await studio.modules.nth(2).click();
		await expect.poll(async () => (await studio.shining()).count).toBeGreaterThan(0);
	});
});

test("a bunch tells what its pedicels asked, what they were answered, and why", { tag: "@long" }, async ({ page }) => {
	const studio = await new StepperPage(page).steps("?v=1&preset=grape-15b");
	await studio.button("Next query").click();
	await expect(studio.details).toContainText(/Query: .+ Response: /);
	const last = Number(await studio.step.getAttribute("max"));
	expect(last).toBeGreaterThan(5);
	await studio.button("First step").click();
	await expect(studio.modules).toHaveCount(1);
	await expect(studio.modules).toHaveText(/^Ar1\(/);
});

test.describe("on a phone", () => {
	test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

	test("nothing sticks out, and modules, steps and productions are in reach", { tag: "@long" }, async ({ page }) => {
		const studio = await new StepperPage(page).steps(ALGAE);
		expect(await studio.overflow()).toBeLessThanOrEqual(0);
		expect((await studio.string.boundingBox())?.height).toBeGreaterThan(90);
		await studio.modules.nth(2).tap();
		await expect(studio.details).toContainText("Produced by line");
		await studio.button("Step back").tap();
		await expect(studio.step).toHaveValue("8");
		for (const name of ["First step", "Step back", "Play the steps", "Step forward", "Last step"])
			expect((await studio.button(name).boundingBox())?.height).toBeGreaterThanOrEqual(40);
	});
});
