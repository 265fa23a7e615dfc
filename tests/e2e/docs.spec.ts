/** Every example of the pages for people, in their order: commands, scripts, pages (tests/docs/ reads and runs them). */
import { pathToFileURL } from "node:url";
import { prepare } from "../../wasm-core/tools/toolchain.mjs";
import { ExampleFolder } from "../docs/example_folder";
import { examplesOf, pages, partOf, plainly, textOf } from "../docs/examples";
import { freePort } from "../free_port.mjs";
import { isLongRun } from "../long_run.mjs";
import { type Project, projectWith } from "../package/project";
import { installed } from "../readers/programs.mjs";
import { expect, test } from "./fixtures";
import { standInForModelViewer } from "./model_viewer";
import { serveUnder } from "./static_server";

let project: Project;
let python: string;
test.beforeAll(async () => {
	project = await projectWith({});
	if (isLongRun) python = await installed("trimesh", (await prepare("trimesh")).python);
});
test.afterAll(() => project.remove());

/** The page whose examples run in the gate, too: its examples need no Python. */
const IN_GATE = "for-web-authors";

for (const name of pages()) {
	test(`docs/${name}.md: its examples do what it says`, { tag: name === IN_GATE ? [] : "@long" }, async ({ page }) => {
		// Many programs, one after the other.
		test.slow();
		const examples = await ExampleFolder.at(project, python);
		const host = await serveUnder("/", pathToFileURL(examples.folder).href);
		await standInForModelViewer(page);
		try {
			// The documented port may be in use.
			const text = textOf(name).replaceAll("8765", String(await freePort()));
			const problems: string[] = [];
			for (const example of examplesOf(text)) {
				if (example.how === "not-run") continue;
				// Runs all examples, so that all errors of a page are reported at once.
				await test.step(`line ${example.line}`, () =>
					examples.run(example).catch(({ message }) => problems.push(message)));
				if (example.language !== "html") continue;
				await page.goto(new URL(example.title ?? "", host.address).href);
				// The page as for a screen reader: texts, and names of other elements.
				if (example.prints === undefined) await page.waitForLoadState("networkidle");
				for (const line of plainly(example.prints ?? "").split("\n"))
					await expect.poll(() => page.locator("body").ariaSnapshot(), { timeout: 60_000 }).toMatch(partOf(line));
			}
			expect(problems.join("\n\n")).toBe("");
		} finally {
			await page.goto("about:blank");
			await host.close();
			await examples.clear();
		}
	});
}
